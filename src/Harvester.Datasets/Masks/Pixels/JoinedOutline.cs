using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;

namespace Harvester.Datasets.Masks.Pixels;

/// <summary>
/// Makes one closed polygon of several, for formats that have one for each object: pieces and holes are joined by the shortest ways between
/// their corners, gone there and back, which have no area. Filled by the even-odd rule, the polygon covers what the outlines together do.
/// </summary>
internal static class JoinedOutline
{
    /// <summary>Joins outlines.</summary>
    /// <param name="outlines">At least one; the polygon begins with the first.</param>
    public static IReadOnlyList<Vector2D> Of(IReadOnlyList<IReadOnlyList<Vector2D>> outlines)
    {
        List<Vector2D> joined = [.. outlines[0]];
        List<Loose> loose = [.. outlines.Skip(1).Select(outline => new Loose(outline, joined))];
        while (loose.Count > 0)
        {
            Loose next = loose.MinBy(candidate => candidate.Distance)!;
            loose.Remove(next);
            int at = joined.IndexOf(next.Anchor);
            Vector2D[] tour = [.. Enumerable.Range(0, next.Outline.Count + 1)
                .Select(step => next.Outline[(next.Corner + step) % next.Outline.Count]), next.Anchor];
            joined.InsertRange(at + 1, tour);
            foreach (Loose candidate in loose)
            {
                candidate.Approach(next.Outline);
            }
        }

        return joined;
    }

    /// <summary>An outline that is not joined yet, and the shortest way to it.</summary>
    private sealed class Loose
    {
        public Loose(IReadOnlyList<Vector2D> outline, IReadOnlyList<Vector2D> joined)
        {
            Outline = outline;
            Approach(joined);
        }

        public IReadOnlyList<Vector2D> Outline { get; }

        /// <summary>Square of the length of the way, pixels.</summary>
        public double Distance { get; private set; } = double.PositiveInfinity;

        /// <summary>Where the way leaves the joined polygon.</summary>
        public Vector2D Anchor { get; private set; }

        /// <summary>Number of the corner at which it arrives.</summary>
        public int Corner { get; private set; }

        /// <summary>Looks whether it is nearer to further corners of the joined polygon.</summary>
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
