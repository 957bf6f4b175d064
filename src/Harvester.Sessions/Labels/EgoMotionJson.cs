using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes the motion of the ego: into a label rounded, into a scene exactly.</summary>
internal static class EgoMotionJson
{
    public const int RateDecimals = 6;
    public const int ControlDecimals = 4;

    /// <summary>The fields of a label's ego.</summary>
    public static void Append(JsonText json, EgoMotion motion)
    {
        json.Key("yawRate")
            .Number(motion.YawRate, RateDecimals)
            .Key("acceleration")
            .Number(motion.Acceleration, LabelDecimals.Speed)
            .Key("steering")
            .Number(motion.Steering, ControlDecimals)
            .Key("throttle")
            .Number(motion.Throttle, ControlDecimals)
            .Key("brake")
            .Number(motion.Brake, ControlDecimals)
            .Key("manoeuvre")
            .String(NameOf(motion));
    }

    /// <summary>The fields of a scene's ego.</summary>
    public static void AppendExact(JsonText json, EgoMotion motion)
    {
        json.Key("yawRate")
            .Exact(motion.YawRate)
            .Key("acceleration")
            .Exact(motion.Acceleration)
            .Key("steering")
            .Exact(motion.Steering)
            .Key("throttle")
            .Exact(motion.Throttle)
            .Key("brake")
            .Exact(motion.Brake)
            .Key("manoeuvre")
            .String(NameOf(motion));
    }

    private static string? NameOf(EgoMotion motion) => motion.Manoeuvre is { } manoeuvre ? JsonName.Of(manoeuvre) : null;
}
