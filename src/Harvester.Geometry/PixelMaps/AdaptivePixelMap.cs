using System.Collections.Generic;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>An instance map by few rays, and how well it is known.</summary>
/// <param name="Map">The numbers of the targets, pixel by pixel; only targets that a ray has met have pixels.</param>
/// <param name="RaysCast">The number of rays cast for it.</param>
/// <param name="IsComplete">Whether it is as exact as was asked for; false when it was stopped before.</param>
/// <param name="ResolutionPixels">The longest side of a cell that is not understood yet, pixels; 1 when there is none.</param>
/// <param name="InterpolatedPixels">The number of pixels within the targets' boxes through which no ray was cast.</param>
/// <param name="Sights">
/// For each target's number whether it is seen: a target that is has a pixel, and one that is not asked may have been left over when the
/// map was stopped. Targets beyond the reach of rays are undetermined.
/// </param>
public sealed record AdaptivePixelMap(
    InstanceMap Map,
    int RaysCast,
    bool IsComplete,
    int ResolutionPixels,
    int InterpolatedPixels,
    IReadOnlyDictionary<ushort, Sight> Sights);
