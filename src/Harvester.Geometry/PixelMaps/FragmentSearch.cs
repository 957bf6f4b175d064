using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Where to ask whether a map misses a part of an object or a gap in it. The places are scattered, few of them on one row or column,
/// so that an arm of one pixel is met as soon as a compact part of its size. A sparser set is a part of a denser one, and all objects
/// share them.
/// </summary>
internal sealed class FragmentSearch(
    ImageSize image, IReadOnlyList<TargetView> views, PixelSamples samples, HiddenPlaces hiddenPlaces, double unsearchedFraction)
{
    /// <summary>At least this share of a silhouette counts as visible while looking for more of it in the open.</summary>
    private const double OpenShare = 0.07;

    /// <summary>
    /// The same where something nearer is seen; there an object shows only through gaps, and so many times fewer places are asked.
    /// </summary>
    private const double HiddenShare = 0.5;
    private const double HiddenRarity = 7.7;

    /// <summary>
    /// Where it shows there, it mostly does so in a strip along the outline of what hides it: so many times as many places as in the open
    /// are asked within so many pixels of the outlines as drawn, of which those of large objects are that inexact.
    /// </summary>
    private const double OutlineDensity = 2;
    private const int OutlineReach = 3;

    /// <summary>Gaps in what is seen are narrower than fragments: so many times as many places are asked.</summary>
    private const double GapDensity = 1.4;

    private readonly ScatteredRank _rank = new(image);

    /// <summary>The places that have not been asked yet, in the order of the objects.</summary>
    /// <param name="map">What is shown so far.</param>
    public IEnumerable<Place> Places(InstanceMap map)
    {
        foreach (TargetView view in views)
        {
            SilhouetteSpans spans = view.Spans;
            double open = 1 / (unsearchedFraction * Math.Max(view.CountedPixels, OpenShare * spans.PixelCount));
            double hidden = 1 / (HiddenRarity * unsearchedFraction * Math.Max(view.CountedPixels, HiddenShare * spans.PixelCount));
            double inside = GapDensity / (unsearchedFraction * view.CountedPixels);
            double outline = OutlineDensity * open;
            double densest = Math.Max(outline, inside);
            for (int row = spans.FirstRow; row <= spans.LastRow; row++)
            {
                (int first, int last) = spans.Row(row);
                for (int column = first; column <= last; column++)
                {
                    double rank = _rank.Of(column, row);
                    if (rank < densest && samples.IsUnasked(column, row) && rank < Density(column, row))
                    {
                        yield return Place.OfPixel(column, row);
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
