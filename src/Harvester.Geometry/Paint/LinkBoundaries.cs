using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>The boundaries of the lanes of one direction of a link, as the lines measured on the link mark them.</summary>
internal static class LinkBoundaries
{
    /// <summary>Distance of the places on a link where the lines are looked at, metres.</summary>
    private const double Step = 2;

    /// <summary>
    /// On a road without a median, a line at most this far from the link's line is the one between the directions, metres: nodes are
    /// stored to 0.25 m, and a road may be painted some way off its line.
    /// </summary>
    private const double MaxFromLine = 1.25;

    /// <summary>
    /// Where not all lines between lanes are seen, a line within this distance of one that is known elsewhere on the link is its
    /// continuation, metres: less than half of the narrowest lane.
    /// </summary>
    private const double SameLine = 0.5;

    /// <summary>Finds the boundaries of a direction with lanes.</summary>
    /// <returns>The median offset of each boundary along the link, metres to the right of the link's line in that direction; null for a
    /// boundary without a line.</returns>
    public static double?[] Of(LinkPaint link, RoadLink road, bool isForward)
    {
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        List<double>[] offsets = [.. Enumerable.Range(0, lanes + 1).Select(_ => new List<double>())];
        var unsorted = new List<double>();
        for (double station = link.SeenFrom; station <= link.SeenTo; station += Step)
        {
            AddBoundaries(link, road, station, isForward, offsets, unsorted);
        }

        double?[] known = [.. offsets.Select(Median)];
        foreach (double offset in unsorted)
        {
            for (int i = 1; i < lanes; i++)
            {
                if (known[i] is { } line && Math.Abs(offset - line) <= SameLine)
                {
                    offsets[i].Add(offset);
                }
            }
        }

        return [.. offsets.Select(Median)];
    }

    /// <summary>
    /// Adds the offsets of the lines at a station, metres to the right in a direction, to the boundaries that they mark, from 0 at the left
    /// edge. A yellow line, and the one between the directions, is the left edge; a solid white one is the edge of its side. A dashed line
    /// lies between lanes; which ones is clear if all of them are seen, and otherwise left open.
    /// </summary>
    private static void AddBoundaries(
        LinkPaint link,
        RoadLink road,
        double station,
        bool isForward,
        List<double>[] offsets,
        List<double> unsorted
    )
    {
        int lanes = offsets.Length - 1;
        bool hasMedian = road.MedianWidth is > 0;
        var dashed = new List<double>();
        foreach (LinePaint line in link.Lines.Where(line => line.FromStation <= station && station <= line.ToStation))
        {
            double offset = isForward ? line.OffsetAt(station) : -line.OffsetAt(station);
            bool isBetween = !road.IsOneWay && !hasMedian && Math.Abs(offset) <= MaxFromLine;
            if (!road.IsOneWay && !isBetween && offset < 0)
            {
                continue;
            }

            if (isBetween || line.Paint.Colour == MarkingColour.Yellow || line.Paint.Style == MarkingStyle.DoubleSolid)
            {
                offsets[0].Add(offset);
            }
            else if (line.Paint.Style == MarkingStyle.Dashed)
            {
                dashed.Add(offset);
            }
            else
            {
                offsets[road.IsOneWay && offset < 0 ? 0 : lanes].Add(offset);
            }
        }

        dashed.Sort();
        if (dashed.Count != lanes - 1)
        {
            unsorted.AddRange(dashed);
            return;
        }

        for (int i = 0; i < dashed.Count; i++)
        {
            offsets[i + 1].Add(dashed[i]);
        }
    }

    private static double? Median(List<double> values)
    {
        values.Sort();
        return values.Count > 0 ? values[values.Count / 2] : null;
    }
}
