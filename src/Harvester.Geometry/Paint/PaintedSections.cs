using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The lanes of links as their measured lines show them. Each line is taken for the boundary that its kind and place name. A boundary lies
/// at the median offset of its line along the link, or where the road next to the link has it. Other boundaries lie between those with a
/// line, or beyond them by their mean distance.
/// </summary>
public static class PaintedSections
{
    /// <summary>Range of the width of a lane, metres; narrower or wider, two lines are not the boundaries they are taken for.</summary>
    private const double MinWidth = 2.2;
    private const double MaxWidth = 7.5;

    /// <summary>
    /// The widest lane of a direction is at most this many times as wide as the narrowest: between lanes of 3 m and 6 m there is another
    /// line, or they are not lanes.
    /// </summary>
    private const double MaxRatio = 1.6;

    /// <summary>Finds the sections.</summary>
    /// <param name="table">The measured lines.</param>
    /// <returns>By link and direction; true for the direction from start to end.</returns>
    public static IReadOnlyDictionary<(int Link, bool IsForward), MeasuredSection> Of(PaintTable table)
    {
        RoadNetwork network = Guard.NotNull(table, nameof(table)).Network;
        var measured = new Dictionary<(int Link, bool IsForward), double?[]>();
        foreach (LinkPaint link in table.Links)
        {
            foreach (bool isForward in Directions(network.Links[link.Link]))
            {
                double?[] boundaries = LinkBoundaries.Of(link, network.Links[link.Link], isForward);
                if (Array.Exists(boundaries, static offset => offset is not null))
                {
                    measured.Add((link.Link, isForward), boundaries);
                }
            }
        }

        var carried = new CarriedBoundaries(network, measured);
        var sections = new Dictionary<(int Link, bool IsForward), MeasuredSection>();
        for (int link = 0; link < network.Links.Count; link++)
        {
            foreach (bool isForward in Directions(network.Links[link]))
            {
                (double?[] boundaries, bool isConfirmed) = carried.Of(link, isForward);
                if (Completed(boundaries, isConfirmed) is { } section)
                {
                    sections.Add((link, isForward), section);
                }
            }
        }

        return sections;
    }

    private static IEnumerable<bool> Directions(RoadLink road)
    {
        if (road.LanesForward > 0)
        {
            yield return true;
        }

        if (road.LanesBackward > 0)
        {
            yield return false;
        }
    }

    /// <summary>The lanes between boundaries of which some are known; null if those are fewer than two, or do not bound lanes.</summary>
    private static MeasuredSection? Completed(double?[] known, bool isConfirmed)
    {
        int first = Array.FindIndex(known, static offset => offset is not null);
        int last = Array.FindLastIndex(known, static offset => offset is not null);
        if (first < 0 || first == last)
        {
            return null;
        }

        // Beyond the known boundaries, lanes have the mean width of those between: (offset(last) - offset(first)) / (last - first).
        double mean = (known[last]!.Value - known[first]!.Value) / (last - first);
        var edges = new double[known.Length];
        int left = first;
        for (int i = 0; i < edges.Length; i++)
        {
            left = i <= last && known[i] is not null ? i : left;
            int right = Array.FindIndex(known, left + 1 > last ? last : left + 1, static offset => offset is not null);
            double width = i > first && i < last && left != i ? (known[right]!.Value - known[left]!.Value) / (right - left) : mean;
            edges[i] = known[left]!.Value + ((i - left) * width);
        }

        double[] widths = [.. Enumerable.Range(0, edges.Length - 1).Select(i => edges[i + 1] - edges[i])];
        bool areLanes = widths.All(width => width is >= MinWidth and <= MaxWidth) && widths.Max() <= MaxRatio * widths.Min();
        return areLanes
            ? new MeasuredSection(edges[0], new LaneSection(widths), IsWhole: isConfirmed && first == 0 && last == edges.Length - 1)
            : null;
    }
}
