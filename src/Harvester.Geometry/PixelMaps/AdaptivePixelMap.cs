using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>An instance map made with few rays, and how accurate it is.</summary>
/// <param name="Map">The targets' numbers, pixel by pixel; only targets that a ray has hit have pixels.</param>
/// <param name="RaysCast">The number of rays cast for it.</param>
/// <param name="IsComplete">Whether it has the requested accuracy; false if it was stopped before.</param>
/// <param name="ResolutionPixels">The longest side of an unresolved cell, pixels; 1 if there is no such cell.</param>
/// <param name="InterpolatedPixels">Number of pixels within the targets' boxes through which no ray was cast.</param>
/// <param name="Sights">
/// For each target's number whether it is visible: a target that is seen has a pixel; one that is not asked was not reached before the map
/// was stopped. Targets beyond the reach of rays are undetermined.
/// </param>
public sealed record AdaptivePixelMap(
    InstanceMap Map,
    int RaysCast,
    bool IsComplete,
    int ResolutionPixels,
    int InterpolatedPixels,
    IReadOnlyDictionary<ushort, Sight> Sights
);
