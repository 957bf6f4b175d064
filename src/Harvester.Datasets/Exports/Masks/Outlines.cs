using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;

namespace Harvester.Datasets.Exports.Masks;

/// <summary>
/// Outlines of an object's pixels along the borders between pixels, corners only. Each part that hangs together by sides of pixels has one
/// outline; holes have none, so that they count as filled.
/// </summary>
internal static class Outlines
{
    /// <summary>The outlines, clockwise as seen in the image, the largest first.</summary>
    public static IReadOnlyList<IReadOnlyList<Vector2D>> Of(InstancePixels pixels)
    {
        Dictionary<(int X, int Y), List<(int X, int Y)>> borders = Borders(pixels);
        var outlines = new List<IReadOnlyList<Vector2D>>();
        foreach ((int X, int Y) start in borders.Keys.OrderBy(corner => corner.Y).ThenBy(corner => corner.X).ToArray())
        {
            while (borders[start].Count > 0)
            {
                List<(int X, int Y)> loop = Follow(borders, start);
                if (TwiceArea(loop) > 0)
                {
                    outlines.Add([.. CornersOf(loop).Select(corner => new Vector2D(corner.X, corner.Y))]);
                }
            }
        }

        return [.. outlines.OrderByDescending(TwiceArea)];
    }

    /// <summary>The steps from corner to corner with the object on their right-hand side.</summary>
    private static Dictionary<(int X, int Y), List<(int X, int Y)>> Borders(InstancePixels pixels)
    {
        var borders = new Dictionary<(int X, int Y), List<(int X, int Y)>>();
        for (int y = pixels.Top; y < pixels.Bottom; y++)
        {
            for (int x = pixels.Left; x < pixels.Right; x++)
            {
                if (!pixels.Contains(x, y))
                {
                    continue;
                }

                AddUnless(pixels.Contains(x, y - 1), (x, y), (x + 1, y));
                AddUnless(pixels.Contains(x + 1, y), (x + 1, y), (x + 1, y + 1));
                AddUnless(pixels.Contains(x, y + 1), (x + 1, y + 1), (x, y + 1));
                AddUnless(pixels.Contains(x - 1, y), (x, y + 1), (x, y));
            }
        }

        return borders;

        void AddUnless(bool isInner, (int X, int Y) from, (int X, int Y) to)
        {
            if (isInner)
            {
                return;
            }

            if (!borders.TryGetValue(from, out List<(int X, int Y)>? steps))
            {
                steps = [];
                borders.Add(from, steps);
            }

            steps.Add(to);
        }
    }

    private static List<(int X, int Y)> Follow(Dictionary<(int X, int Y), List<(int X, int Y)>> borders, (int X, int Y) start)
    {
        var loop = new List<(int X, int Y)>();
        (int X, int Y) at = start;
        (int X, int Y) heading = default;
        do
        {
            loop.Add(at);
            List<(int X, int Y)> steps = borders[at];

            // Where two pixels meet in a corner only, the turn to the right stays with the same pixel: (x, y) turned right is (-y, x) with y down.
            (int X, int Y) right = (at.X - heading.Y, at.Y + heading.X);
            (int X, int Y) next = steps.Count > 1 && steps.Contains(right) ? right : steps[0];
            steps.Remove(next);
            heading = (next.X - at.X, next.Y - at.Y);
            at = next;
        }
        while (at != start);
        return loop;
    }

    private static IEnumerable<(int X, int Y)> CornersOf(List<(int X, int Y)> loop)
    {
        for (int i = 0; i < loop.Count; i++)
        {
            (int X, int Y) before = loop[(i + loop.Count - 1) % loop.Count];
            (int X, int Y) after = loop[(i + 1) % loop.Count];
            if (before.X != after.X && before.Y != after.Y)
            {
                yield return loop[i];
            }
        }
    }

    private static long TwiceArea(List<(int X, int Y)> loop) =>
        loop.Select((corner, i) => (corner, next: loop[(i + 1) % loop.Count])).Sum(step => ((long)step.corner.X * step.next.Y) - ((long)step.next.X * step.corner.Y));

    private static double TwiceArea(IReadOnlyList<Vector2D> outline) =>
        outline.Select((corner, i) => (corner, next: outline[(i + 1) % outline.Count])).Sum(step => (step.corner.X * step.next.Y) - (step.next.X * step.corner.Y));
}
