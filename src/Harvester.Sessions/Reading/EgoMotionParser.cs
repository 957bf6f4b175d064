using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the motion of the ego from a label or a scene.</summary>
internal static class EgoMotionParser
{
    /// <summary>The motion; null in sessions of earlier versions and of games that do not report it.</summary>
    /// <exception cref="DatasetFormatException">A field is invalid.</exception>
    public static EgoMotion? Parse(JsonFields ego) =>
        !ego.Has("yawRate")
            ? null
            : new EgoMotion(ego.Number("yawRate"), ego.Number("acceleration"))
            {
                Steering = ego.OptionalNumber("steering"),
                Throttle = ego.OptionalNumber("throttle"),
                Brake = ego.OptionalNumber("brake"),
                Manoeuvre = ego.Has("manoeuvre") ? ego.Name<Manoeuvre>("manoeuvre") : null,
            };
}
