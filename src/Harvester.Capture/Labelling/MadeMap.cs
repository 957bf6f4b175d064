using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;

namespace Harvester.Capture.Labelling;

/// <summary>A finished instance map, by whatever method.</summary>
/// <param name="Map">The targets' numbers, pixel by pixel.</param>
/// <param name="Sights">For each target's number whether it is visible.</param>
/// <param name="Label">Its accuracy, for the label of the frame.</param>
internal sealed record MadeMap(InstanceMap Map, IReadOnlyDictionary<ushort, Sight> Sights, PixelMapLabel Label)
{
    /// <summary>For each target's number its amodal mask; empty for a map from rays.</summary>
    public IReadOnlyDictionary<ushort, PixelMap> Amodal { get; init; } = new Dictionary<ushort, PixelMap>();

    /// <summary>A map from rays.</summary>
    public static MadeMap Of(AdaptivePixelMap map) =>
        new(map.Map, map.Sights, new PixelMapLabel(map.ResolutionPixels, map.InterpolatedPixels, map.RaysCast));

    /// <summary>The amodal mask of a target for its label; null if it has none.</summary>
    public AmodalMask? AmodalOf(ushort number) =>
        Amodal.TryGetValue(number, out PixelMap? pixels) && pixels.Count > 0 ? AmodalMask.Of(pixels) : null;
}
