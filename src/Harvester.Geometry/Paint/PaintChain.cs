using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>The rows of links that continue each other, as one strip.</summary>
internal sealed class PaintChain
{
    private PaintChain(IReadOnlyList<ChainRow> rows) => Rows = rows;

    /// <summary>The rows in the order of the chain.</summary>
    public IReadOnlyList<ChainRow> Rows { get; }

    /// <summary>The chains of all links that were seen; each link is in one of them.</summary>
    public static IEnumerable<PaintChain> Of(PaintRoads roads, PaintEvidence evidence)
    {
        var seen = new HashSet<int>(evidence.Links);
        var done = new HashSet<int>();
        foreach (int link in evidence.Links)
        {
            if (!done.Contains(link))
            {
                yield return new PaintChain(RowsOf(roads, evidence, Links(roads.Curves, seen, link, done)));
            }
        }
    }

    private static List<(int Link, bool IsForward)> Links(RoadCurves curves, HashSet<int> seen, int link, HashSet<int> done)
    {
        done.Add(link);
        List<(int, bool)> behind = Follow(curves, seen, (link, false), done);
        behind.Reverse();
        return [.. behind.ConvertAll(place => (place.Item1, !place.Item2)), (link, true), .. Follow(curves, seen, (link, true), done)];
    }

    private static List<(int Link, bool IsForward)> Follow(
        RoadCurves curves,
        HashSet<int> seen,
        (int Link, bool IsForward) place,
        HashSet<int> done
    )
    {
        var followed = new List<(int, bool)>();
        while (true)
        {
            RoadLink road = curves.Network.Links[place.Link];
            int node = place.IsForward ? road.To : road.From;
            int next = curves.Continuations.Of(place.Link, place.IsForward);
            if (next == RoadContinuations.None || !seen.Contains(next) || !done.Add(next))
            {
                return followed;
            }

            place = (next, curves.Network.Links[next].From == node);
            followed.Add(place);
        }
    }

    private static List<ChainRow> RowsOf(PaintRoads roads, PaintEvidence evidence, List<(int Link, bool IsForward)> links)
    {
        var rows = new List<ChainRow>();
        double start = 0;
        foreach ((int link, bool isForward) in links)
        {
            double length = roads.Curves.Of(link).Length;
            int count = roads.RowsOf(link);
            for (int i = 0; i < count; i++)
            {
                int row = isForward ? i : count - 1 - i;
                double station = roads.StationOf(link, row);
                rows.Add(new ChainRow(link, row, isForward, start + (isForward ? station : length - station), evidence.RowOf(link, row)));
            }

            start += length;
        }

        return rows;
    }
}
