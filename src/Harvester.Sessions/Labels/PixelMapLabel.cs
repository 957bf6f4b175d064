namespace Harvester.Sessions.Labels;

/// <summary>How well the instance mask of a frame is known: what the harvest's own pixel map says of itself.</summary>
/// <param name="ResolutionPixels">The longest side of a part of the mask that is not understood, pixels; 1 when there is none.</param>
/// <param name="InterpolatedPixels">Pixels within the objects' boxes that are drawn between rays, not asked by one.</param>
/// <param name="RaysCast">The rays that the map itself took; those of the whole frame are in <see cref="RayCounts"/>.</param>
public sealed record PixelMapLabel(int ResolutionPixels, int InterpolatedPixels, int RaysCast);
