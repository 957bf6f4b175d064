using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The lanes of links as their measured lines show them. Each line is taken for the boundary that its kind and place name; two different
/// boundaries of a direction give the lanes, which share the width between them.
/// </summary>
public static class PaintedSections
{
    /// <summary>Distance of the places on a link where the lines are looked at, metres.</summary>
    private const double Step = 2;

    /// <summary>
    /// On a road without a median, a line at most this far from the link's line is the one between the directions, metres: nodes are
    /// stored to 0.25 m, and a road may be painted some way off its line, but no lane is narrower than twice this.
    /// </summary>
    private const double MaxFromLine = 1.25;

    /// <summary>Range of the width of a lane, metres; narrower or wider, two lines are not the boundaries they are taken for.</summary>
    private const double MinWidth = 2.5;
    private const double MaxWidth = 7.5;

    /// <summary>A line farther than this from lanes of equal width contradicts them, metres.</summary>
    private const double MaxDeviation = 0.5;

    /// <summary>Finds the sections.</summary>
    /// <param name="table">The measured lines.</param>
    /// <returns>By link and direction; true for the direction from start to end.</returns>
    public static IReadOnlyDictionary<(int Link, bool IsForward), MeasuredSection> Of(PaintTable table)
    {
        Guard.NotNull(table, nameof(table));
        var sections = new Dictionary<(int Link, bool IsForward), MeasuredSection>();
        foreach (LinkPaint link in table.Links)
        {
            RoadLink road = table.Network.Links[link.Link];
            foreach (bool isForward in new[] { true, false })
            {
                if (SectionOf(link, road, isForward) is { } section)
                {
                    sections.Add((link.Link, isForward), section);
                }
            }
        }

        return sections;
    }

    private static MeasuredSection? SectionOf(LinkPaint link, RoadLink road, bool isForward)
    {
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        var lefts = new List<double>();
        var widths = new List<double>();
        for (double station = link.SeenFrom; lanes > 0 && station <= link.SeenTo; station += Step)
        {
            if (Fit(BoundariesAt(link, road, station, isForward)) is { } section)
            {
                lefts.Add(section.LeftEdge);
                widths.Add(section.LaneWidth);
            }
        }

        return lefts.Count > 0 ? new MeasuredSection(Median(lefts), Median(widths)) : null;
    }

    /// <summary>
    /// The boundaries that lines at a station mark, from 0 at the left edge of a direction, with their offsets, metres to the right in that
    /// direction. A yellow line, and the one between the directions, is the left edge; a dashed line lies between lanes, and which ones is
    /// clear if all of them are seen; a solid white one is the edge of its side.
    /// </summary>
    private static List<(int Index, double Offset)> BoundariesAt(LinkPaint link, RoadLink road, double station, bool isForward)
    {
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        bool isOneWay = road.IsOneWay;
        bool hasMedian = road.MedianWidth is > 0;
        var boundaries = new List<(int Index, double Offset)>();
        var dashed = new List<double>();
        foreach (LinePaint line in link.Lines.Where(line => line.FromStation <= station && station <= line.ToStation))
        {
            double offset = isForward ? line.OffsetAt(station) : -line.OffsetAt(station);
            bool isBetween = !isOneWay && !hasMedian && Math.Abs(offset) <= MaxFromLine;
            if (!isOneWay && !isBetween && offset < 0)
            {
                continue;
            }

            if (isBetween || line.Paint.Colour == MarkingColour.Yellow || line.Paint.Style == MarkingStyle.DoubleSolid)
            {
                boundaries.Add((0, offset));
            }
            else if (line.Paint.Style == MarkingStyle.Dashed)
            {
                dashed.Add(offset);
            }
            else
            {
                boundaries.Add((isOneWay && offset < 0 ? 0 : lanes, offset));
            }
        }

        dashed.Sort();
        if (dashed.Count == lanes - 1)
        {
            boundaries.AddRange(dashed.Select((offset, i) => (i + 1, offset)));
        }

        return boundaries;
    }

    /// <summary>The lanes through boundaries; null if fewer than two are known, or they are not those of lanes of equal width.</summary>
    private static MeasuredSection? Fit(List<(int Index, double Offset)> boundaries)
    {
        if (boundaries.Select(boundary => boundary.Index).Distinct().Count() < 2)
        {
            return null;
        }

        // Least squares of offset = left + index width: width = cov(index, offset) / var(index), left from the means.
        double meanIndex = boundaries.Average(boundary => boundary.Index);
        double meanOffset = boundaries.Average(boundary => boundary.Offset);
        double variance = boundaries.Sum(boundary => (boundary.Index - meanIndex) * (boundary.Index - meanIndex));
        double width = boundaries.Sum(boundary => (boundary.Index - meanIndex) * (boundary.Offset - meanOffset)) / variance;
        double left = meanOffset - (width * meanIndex);
        bool agrees = boundaries.All(boundary => Math.Abs(boundary.Offset - left - (width * boundary.Index)) <= MaxDeviation);
        return agrees && width is >= MinWidth and <= MaxWidth ? new MeasuredSection(left, width) : null;
    }

    private static double Median(List<double> values)
    {
        values.Sort();
        return values[values.Count / 2];
    }
}
