using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Formats.OpenLaneV2;

/// <summary>A traffic light or road sign in the image that tells the traffic of lanes what to do.</summary>
/// <param name="Id">The id of the object.</param>
/// <param name="Category">1 a light, 2 a sign.</param>
/// <param name="Attribute">The state of a light, or what a sign says; 0 unknown.</param>
/// <param name="Box">Pixels.</param>
/// <param name="Lanes">Names of the lanes that it governs.</param>
internal sealed record TrafficElement(int Id, int Category, int Attribute, Box2D Box, IReadOnlyList<string> Lanes)
{
    /// <summary>The benchmark's number of a light, and the greatest number of a state.</summary>
    public const int Light = 1;

    /// <summary>The benchmark's number of a sign.</summary>
    public const int Sign = 2;

    /// <summary>The benchmark's greatest attribute.</summary>
    public const int LastAttribute = 12;

    /// <summary>The signs about turns among the benchmark's attributes, by their codes in the MUTCD.</summary>
    private static readonly Dictionary<string, int> Signs = new(StringComparer.Ordinal)
    {
        ["R3-2"] = 7,
        ["R3-1"] = 8,
        ["R3-4"] = 10,
    };

    /// <summary>The elements of a frame: heads of lights that face the camera, lights without known heads, and signs about turns.</summary>
    public static IEnumerable<TrafficElement> Of(FrameLabel frame)
    {
        HashSet<int> withHeads = [.. frame.Objects.Where(label => label.KnownParts > 0).Select(label => label.Id)];
        foreach (ObjectLabel label in frame.Objects.Where(label => !label.IsUndetermined))
        {
            IReadOnlyList<string> lanes = label.GovernedLanes ?? [];
            if (label.Class == ObjectClass.TrafficLight && label.Face?.FacesCamera != false && !withHeads.Contains(label.Id))
            {
                yield return new TrafficElement(label.Id, Light, StateOf(label.Face?.Light?.State), label.Box2D, lanes);
            }
            else if (label.Face is { FacesCamera: true, MutcdCode: { } code } && Signs.TryGetValue(code, out int attribute))
            {
                yield return new TrafficElement(label.Id, Sign, attribute, label.Box2D, lanes);
            }
        }
    }

    private static int StateOf(LightState? state) =>
        state switch
        {
            LightState.Red => 1,
            LightState.Green => 2,
            LightState.Amber => 3,
            _ => 0,
        };
}
