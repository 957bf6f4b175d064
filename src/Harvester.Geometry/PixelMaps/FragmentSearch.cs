using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Chooses points at which a map may miss a part of an object or a gap in it. The points are scattered, few of them on one row or column,
/// so that an arm one pixel wide is hit as soon as a compact part of its size. A sparser set is a subset of a denser one, and all objects
/// share the points.
/// </summary>
internal sealed class FragmentSearch(
    ImageSize image,
    IReadOnlyList<TargetView> views,
    PixelSamples samples,
    HiddenPlaces hiddenPlaces,
    double unsearchedFraction
)
{
    /// <summary>
    /// Minimum fraction of a silhouette that counts as visible when searching for more of it where nothing nearer is seen.
    /// </summary>
    private const double OpenFraction = 0.07;

    /// <summary>The same where something nearer is seen. There an object shows only through gaps, so fewer points are sampled.</summary>
    private const double HiddenFraction = 0.5;
    private const double HiddenRarity = 7.7;

    /// <summary>
    /// Where an object is partly hidden, it mostly shows in a strip along the outline of what hides it: this factor applies to the number
    /// of points near the outlines as drawn, which are inexact for large objects.
    /// </summary>
    private const double OutlineDensity = 2;
    private const int OutlineReach = 3;

    /// <summary>Gaps in a visible object are narrower than fragments: factor on the number of points.</summary>
    private const double GapDensity = 1.4;

    private readonly ScatteredRank _rank = new(image);

    /// <summary>The points that have not been sampled yet, in the order of the objects.</summary>
    /// <param name="map">The map so far.</param>
    public IEnumerable<SubpixelPoint> Places(InstanceMap map)
    {
        foreach (TargetView view in views)
        {
            SilhouetteSpans spans = view.Spans;

            // Density of points, per pixel: a missed part of unsearchedFraction of the object's visible pixels has one point in it on
            // average, 1 / (fraction · visible).
            double open = 1 / (unsearchedFraction * Math.Max(view.CountedPixels, OpenFraction * spans.PixelCount));
            double hidden = 1 / (HiddenRarity * unsearchedFraction * Math.Max(view.CountedPixels, HiddenFraction * spans.PixelCount));
            double inside = GapDensity / (unsearchedFraction * view.CountedPixels);
            double outline = OutlineDensity * open;
            double densest = Math.Max(outline, inside);
            for (int row = spans.FirstRow; row <= spans.LastRow; row++)
            {
                (int first, int last) = spans.Row(row);
                for (int column = first; column <= last; column++)
                {
                    // The pixels of rank below d are scattered evenly and make up the fraction d of all.
                    double rank = _rank.Of(column, row);
                    if (rank < densest && samples.IsUnsampled(column, row) && rank < Density(column, row))
                    {
                        yield return SubpixelPoint.OfPixel(column, row);
                    }
                }
            }

            double Density(int column, int row) =>
                map[column, row] == view.Target.Number ? inside
                : !hiddenPlaces.IsHidden(view.Target, map, column, row) ? open
                : IsNearOutline(map, column, row) ? outline
                : hidden;
        }
    }

    private static bool IsNearOutline(InstanceMap map, int column, int row)
    {
        ushort number = map[column, row];
        return map[Math.Max(0, column - OutlineReach), row] != number
            || map[Math.Min(map.Image.Width - 1, column + OutlineReach), row] != number
            || map[column, Math.Max(0, row - OutlineReach)] != number
            || map[column, Math.Min(map.Image.Height - 1, row + OutlineReach)] != number;
    }
}
