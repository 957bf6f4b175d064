namespace Harvester.Sessions.Labels;

/// <summary>The accuracy of the instance mask of a frame, as the harvest's own pixel map reports it.</summary>
/// <param name="ResolutionPixels">The longest side of an unresolved part of the mask, pixels; 1 if there is none.</param>
/// <param name="InterpolatedPixels">Number of pixels within the objects' boxes that are drawn between rays instead of sampled by
/// one.</param>
/// <param name="RaysCast">The rays of the map itself; those of the whole frame are in <see cref="RayCounts"/>.</param>
public sealed record PixelMapLabel(int ResolutionPixels, int InterpolatedPixels, int RaysCast)
{
    /// <summary>Number of photographs from which the mask was decoded; null for a mask from rays.</summary>
    public int? Pictures { get; init; }

    /// <summary>Number of pixels of which the photographs do not show clearly what they are; null for a mask from rays.</summary>
    public int? UndeterminedPixels { get; init; }
}
