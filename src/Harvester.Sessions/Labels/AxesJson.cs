using Harvester.Geometry;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Labels;

/// <summary>Writes three axes.</summary>
internal static class AxesJson
{
    public static void Append(JsonText json, Axes axes) =>
        json.Key("right")
            .Vector(axes.Right, LabelDecimals.Axis)
            .Key("forward")
            .Vector(axes.Forward, LabelDecimals.Axis)
            .Key("up")
            .Vector(axes.Up, LabelDecimals.Axis);
}
