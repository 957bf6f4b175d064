using Harvester.Datasets.Logs;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.MotionScenarios;

/// <summary>What the lights in an image tell lanes.</summary>
internal static class MotionLights
{
    /// <summary>The lights by the names of their lanes. If heads tell a lane different things, it is unknown.</summary>
    public static IReadOnlyDictionary<string, LogLight> Of(FrameLabel label)
    {
        var lights = new SortedDictionary<string, LogLight>(StringComparer.Ordinal);
        foreach (ObjectLabel head in label.Objects.Where(item => item is { GovernedLanes.Count: > 0, Face.Light: not null }))
        {
            LogLight light = LightOf(head.Face!.Light!.State);
            foreach (string lane in head.GovernedLanes!)
            {
                lights[lane] = Both(lights.TryGetValue(lane, out LogLight other) ? other : LogLight.Unknown, light);
            }
        }

        return lights;
    }

    /// <summary>What two sources say together: a known one wins over none; those that contradict each other say nothing.</summary>
    private static LogLight Both(LogLight one, LogLight other) =>
        one == LogLight.Unknown || one == other ? other
        : other == LogLight.Unknown ? one
        : LogLight.Unknown;

    private static LogLight LightOf(LightState state) =>
        state switch
        {
            LightState.Red => LogLight.Stop,
            LightState.Amber => LogLight.Caution,
            LightState.Green => LogLight.Go,
            _ => LogLight.Unknown,
        };
}
