using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>The boundaries of the lanes of one direction of a link, as the lines measured on the link mark them.</summary>
internal static class LinkBoundaries
{
    /// <summary>Distance of the places on a link where the lines are looked at, metres.</summary>
    public const double Step = 2;

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
    /// <returns>The places of each boundary: stations from the link's start, offsets to the right of the link's line in that direction.
    /// Empty for a boundary without a line.</returns>
    public static List<BoundaryPlace>[] Of(LinkPaint link, RoadLink road, bool isForward)
    {
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        List<BoundaryPlace>[] places = [.. Enumerable.Range(0, lanes + 1).Select(_ => new List<BoundaryPlace>())];
        var unsorted = new List<BoundaryPlace>();
        int steps = Math.Max(1, (int)Math.Ceiling((link.SeenTo - link.SeenFrom) / Step));
        for (int i = 0; i <= steps; i++)
        {
            AddBoundaries(link, road, link.SeenFrom + ((link.SeenTo - link.SeenFrom) * i / steps), isForward, places, unsorted);
        }

        List<BoundaryPlace>[] known = [.. places.Select(static line => new List<BoundaryPlace>(line))];
        foreach (BoundaryPlace place in unsorted)
        {
            for (int i = 1; i < lanes; i++)
            {
                if (known[i].Count > 0 && Math.Abs(place.Offset - Nearest(known[i], place.Station).Offset) <= SameLine)
                {
                    places[i].Add(place);
                }
            }
        }

        return [.. places.Select(OnePerStation)];
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
        List<BoundaryPlace>[] places,
        List<BoundaryPlace> unsorted
    )
    {
        int lanes = places.Length - 1;
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
                places[0].Add(new BoundaryPlace(station, offset));
            }
            else if (line.Paint.Style == MarkingStyle.Dashed)
            {
                dashed.Add(offset);
            }
            else
            {
                places[road.IsOneWay && offset < 0 ? 0 : lanes].Add(new BoundaryPlace(station, offset));
            }
        }

        dashed.Sort();
        if (dashed.Count != lanes - 1)
        {
            unsorted.AddRange(dashed.Select(offset => new BoundaryPlace(station, offset)));
            return;
        }

        for (int i = 0; i < dashed.Count; i++)
        {
            places[i + 1].Add(new BoundaryPlace(station, dashed[i]));
        }
    }

    private static BoundaryPlace Nearest(List<BoundaryPlace> line, double station) =>
        line.OrderBy(place => Math.Abs(place.Station - station)).First();

    /// <summary>
    /// The places of a boundary by station: of several lines that may mark it at a station, the one nearest to the median along the link.
    /// </summary>
    private static List<BoundaryPlace> OnePerStation(List<BoundaryPlace> line)
    {
        double[] offsets = [.. line.Select(static place => place.Offset).OrderBy(static offset => offset)];
        return
        [
            .. line.GroupBy(static place => place.Station)
                .Select(places => places.OrderBy(place => Math.Abs(place.Offset - offsets[offsets.Length / 2])).First())
                .OrderBy(static place => place.Station),
        ];
    }
}
