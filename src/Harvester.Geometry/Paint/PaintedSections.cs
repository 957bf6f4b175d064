using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The lanes along links as their measured lines show them. Each line is taken for the boundary that its kind and place name. Where a
/// boundary was not seen, it lies as on the road next to it. Boundaries that were not seen at all lie between those with a line, or beyond
/// them by their mean distance; if only one boundary of a direction was seen, by that of the other direction.
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

    /// <summary>Distance of sections along a link, metres: that of the places from which lines are measured.</summary>
    private const double SectionStep = 5;

    /// <summary>A section is left out if its edges are this near to the straight lines between others, metres.</summary>
    private const double MaxBow = 0.005;

    /// <summary>Finds the lanes.</summary>
    /// <param name="table">The measured lines.</param>
    /// <param name="curves">The centre lines of the table's network.</param>
    /// <returns>By link and direction; true for the direction from start to end.</returns>
    public static IReadOnlyDictionary<(int Link, bool IsForward), MeasuredLanes> Of(PaintTable table, RoadCurves curves)
    {
        RoadNetwork network = Guard.NotNull(table, nameof(table)).Network;
        Guard.NotNull(curves, nameof(curves));
        var measured = new Dictionary<(int Link, bool IsForward), List<BoundaryPlace>[]>();
        foreach (LinkPaint link in table.Links)
        {
            foreach (bool isForward in Directions(network.Links[link.Link]))
            {
                List<BoundaryPlace>[] places = LinkBoundaries.Of(link, network.Links[link.Link], isForward);
                if (Array.Exists(places, static line => line.Count > 0))
                {
                    measured.Add((link.Link, isForward), places);
                }
            }
        }

        var boundaries = new RoadBoundaries(curves, measured);
        var lanes = new Dictionary<(int Link, bool IsForward), MeasuredLanes>();
        for (int link = 0; link < network.Links.Count; link++)
        {
            foreach (bool isForward in Directions(network.Links[link]))
            {
                if (boundaries.Around(link, isForward) is { } profiles)
                {
                    bool isConfirmed = measured.ContainsKey((link, isForward));
                    List<(double Station, MeasuredSection Section)> sections = Sections(
                        profiles,
                        boundaries.Around(link, !isForward),
                        curves.Of(link).Length,
                        isForward,
                        isConfirmed
                    );
                    if (sections.Count > 0)
                    {
                        lanes.Add((link, isForward), new MeasuredLanes(sections));
                    }
                }
            }
        }

        return lanes;
    }

    /// <summary>The sections along a link by their stations from its start, where the boundaries bound lanes.</summary>
    private static List<(double Station, MeasuredSection Section)> Sections(
        BoundaryProfiles own,
        BoundaryProfiles? other,
        double length,
        bool isForward,
        bool isConfirmed
    )
    {
        // A link between two nodes at one place has one section.
        int steps = (int)Math.Ceiling(length / SectionStep);
        var sections = new List<(double Station, MeasuredSection Section)>();
        for (int i = 0; i <= steps; i++)
        {
            double station = steps == 0 ? 0 : length * i / steps;
            double along = isForward ? station : length - station;
            if (Completed(own.At(along), isConfirmed, other is null ? null : MeanWidth(other.At(length - along))) is { } section)
            {
                sections.Add((station, section));
            }
        }

        return Thinned(sections);
    }

    /// <summary>The first and last section, and of those between as many as describe all.</summary>
    private static List<(double Station, MeasuredSection Section)> Thinned(List<(double Station, MeasuredSection Section)> sections)
    {
        List<(double Station, MeasuredSection Section)> kept = [.. sections.Take(1)];
        int from = 0;
        for (int i = 2; i < sections.Count; i++)
        {
            MeasuredLanes between = new([sections[from], sections[i]]);
            if (!sections.GetRange(from + 1, i - from - 1).TrueForAll(place => IsSame(between.At(place.Station), place.Section)))
            {
                from = i - 1;
                kept.Add(sections[from]);
            }
        }

        kept.AddRange(sections.Skip(Math.Max(1, sections.Count - 1)));
        return kept;
    }

    private static bool IsSame(MeasuredSection a, MeasuredSection b) =>
        a.IsWhole == b.IsWhole
        && Enumerable
            .Range(0, a.Section.LaneCount + 1)
            .All(edge => Math.Abs(a.LeftEdge + a.Section.Edge(edge) - b.LeftEdge - b.Section.Edge(edge)) <= MaxBow);

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

    /// <summary>Mean width of the lanes between the outermost known boundaries: (offset(last) - offset(first)) / (last - first).</summary>
    private static double? MeanWidth(double?[] known)
    {
        int first = Array.FindIndex(known, static offset => offset is not null);
        int last = Array.FindLastIndex(known, static offset => offset is not null);
        return first < last ? (known[last]!.Value - known[first]!.Value) / (last - first) : null;
    }

    /// <summary>
    /// The lanes between boundaries of which some are known; null if there are none, there is only one and the width of the lanes of the
    /// other direction is not known, or they do not bound lanes.
    /// </summary>
    private static MeasuredSection? Completed(double?[] known, bool isConfirmed, double? otherWidth)
    {
        // Beyond the known boundaries, lanes have the mean width of those between.
        int first = Array.FindIndex(known, static offset => offset is not null);
        int last = Array.FindLastIndex(known, static offset => offset is not null);
        if (first < 0 || (MeanWidth(known) ?? otherWidth) is not { } mean)
        {
            return null;
        }

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
