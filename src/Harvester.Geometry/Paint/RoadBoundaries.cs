using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The boundaries of the lanes along roads: those measured on a link and on the others of the same road, which continue it without a
/// junction and have the same lanes.
/// </summary>
/// <param name="curves">The centre lines.</param>
/// <param name="measured">The measured places of boundaries by link and direction, with stations along the link from its start.</param>
internal sealed class RoadBoundaries(RoadCurves curves, IReadOnlyDictionary<(int Link, bool IsForward), List<BoundaryPlace>[]> measured)
{
    private readonly int[] _linksAt = LinksAt(curves.Network);

    /// <summary>The boundaries of a direction along a link and the road next to it, by stations in the direction of travel from where the
    /// link is entered; null if none is known, or the direction has no lanes.</summary>
    public BoundaryProfiles? Around(int link, bool isForward)
    {
        RoadLink road = curves.Network.Links[link];
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        if (lanes == 0)
        {
            return null;
        }

        List<BoundaryPlace>[] places = [.. Enumerable.Range(0, lanes + 1).Select(_ => new List<BoundaryPlace>())];
        AddAlong(places, link, isForward, ahead: false);
        AddLink(places, link, isForward, 0);
        AddAlong(places, link, isForward, ahead: true);
        if (!Array.Exists(places, static line => line.Count > 0))
        {
            return null;
        }

        Array.ForEach(places, static line => line.Sort(static (a, b) => a.Station.CompareTo(b.Station)));
        return new BoundaryProfiles(places);
    }

    private static int[] LinksAt(RoadNetwork network)
    {
        int[] links = new int[network.Nodes.Count];
        foreach (RoadLink link in network.Links)
        {
            links[link.From]++;
            links[link.To]++;
        }

        return links;
    }

    /// <summary>Adds the places on a link that is entered at a station.</summary>
    private void AddLink(List<BoundaryPlace>[] places, int link, bool isForward, double entry)
    {
        if (measured.TryGetValue((link, isForward), out List<BoundaryPlace>[]? found))
        {
            double length = curves.Of(link).Length;
            for (int i = 0; i < places.Length; i++)
            {
                places[i]
                    .AddRange(
                        found[i].Select(place => place with { Station = entry + (isForward ? place.Station : length - place.Station) })
                    );
            }
        }
    }

    /// <summary>Adds the places on the links ahead or behind that are the same road.</summary>
    private void AddAlong(List<BoundaryPlace>[] places, int link, bool isForward, bool ahead)
    {
        double entry = 0;
        int at = link;
        bool along = isForward;
        for (double distance = 0; distance <= BoundaryProfiles.MaxDistance; distance += curves.Of(at).Length)
        {
            RoadLink road = curves.Network.Links[at];
            int node = along == ahead ? road.To : road.From;
            int next = curves.Continuations.Of(at, beyondEnd: along == ahead);
            if (next == RoadContinuations.None || next == link || _linksAt[node] != 2)
            {
                return;
            }

            bool nextAlong = (curves.Network.Links[next].From == node) == ahead;
            if (!HasSameLanes(road, along, curves.Network.Links[next], nextAlong))
            {
                return;
            }

            entry += ahead ? curves.Of(at).Length : -curves.Of(next).Length;
            (at, along) = (next, nextAlong);
            AddLink(places, at, along, entry);
        }
    }

    private static bool HasSameLanes(RoadLink one, bool oneForward, RoadLink other, bool otherForward)
    {
        RoadLink a = oneForward ? one : one.Reversed();
        RoadLink b = otherForward ? other : other.Reversed();
        return (a.LanesForward, a.LanesBackward, a.MedianWidth, a.Flags) == (b.LanesForward, b.LanesBackward, b.MedianWidth, b.Flags);
    }
}
