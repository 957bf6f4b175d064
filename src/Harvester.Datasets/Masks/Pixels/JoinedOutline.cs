using Harvester.Geometry;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>
/// Joins several polygons into one, for formats with one polygon per object: regions and holes are connected by the shortest segments
/// between their corners, traversed in both directions, which enclose no area. By the even-odd rule, the polygon covers the same pixels as
/// the outlines.
/// </summary>
internal static class JoinedOutline
{
    /// <summary>Joins outlines.</summary>
    /// <param name="outlines">At least one outline; the polygon begins with the first.</param>
    public static IReadOnlyList<Vector2D> Of(IReadOnlyList<IReadOnlyList<Vector2D>> outlines)
    {
        List<Vector2D> joined = [.. outlines[0]];
        List<Loose> loose = [.. outlines.Skip(1).Select(outline => new Loose(outline, joined))];
        while (loose.Count > 0)
        {
            Loose next = loose.MinBy(candidate => candidate.Distance)!;
            loose.Remove(next);
            int at = joined.IndexOf(next.Anchor);
            Vector2D[] tour =
            [
                .. Enumerable.Range(0, next.Outline.Count + 1).Select(step => next.Outline[(next.Corner + step) % next.Outline.Count]),
                next.Anchor,
            ];
            joined.InsertRange(at + 1, tour);
            foreach (Loose candidate in loose)
            {
                candidate.Approach(next.Outline);
            }
        }

        return joined;
    }

    /// <summary>An outline that is not joined yet, and the shortest segment to it.</summary>
    private sealed class Loose
    {
        public Loose(IReadOnlyList<Vector2D> outline, IReadOnlyList<Vector2D> joined)
        {
            Outline = outline;
            Approach(joined);
        }

        public IReadOnlyList<Vector2D> Outline { get; }

        /// <summary>Square of the segment's length, pixels.</summary>
        public double Distance { get; private set; } = double.PositiveInfinity;

        /// <summary>Start of the segment on the joined polygon.</summary>
        public Vector2D Anchor { get; private set; }

        /// <summary>Index of the corner at its end.</summary>
        public int Corner { get; private set; }

        /// <summary>Updates the segment for new corners of the joined polygon.</summary>
        public void Approach(IReadOnlyList<Vector2D> corners)
        {
            foreach (Vector2D anchor in corners)
            {
                for (int i = 0; i < Outline.Count; i++)
                {
                    Vector2D way = Outline[i] - anchor;
                    if (way.Dot(way) < Distance)
                    {
                        (Distance, Anchor, Corner) = (way.Dot(way), anchor, i);
                    }
                }
            }
        }
    }
}
