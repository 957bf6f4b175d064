namespace Harvester.Geometry.Roads;

/// <summary>
/// The link that continues a road beyond each of a link's nodes. Where two drivable links meet, they continue each other; where more meet,
/// those pairs that bend least. A pair is mutual, and it can be driven through in at least one direction.
/// </summary>
public sealed class RoadContinuations
{
    /// <summary>The value of <see cref="Of"/> if the road ends or nothing continues it.</summary>
    public const int None = -1;

    /// <summary>Nodes of these kinds are not on a road for cars.</summary>
    private const RoadNodeFlags OffTheRoad =
        RoadNodeFlags.PedestrianCrossing
        | RoadNodeFlags.PedestrianCrossingWithoutWait
        | RoadNodeFlags.PedestrianAssisted
        | RoadNodeFlags.Water;

    /// <summary>If only two links meet, a sharper bend than this is a U-turn, radians: 115 degrees.</summary>
    private const double MaxBend = 2.0;

    /// <summary>If more than two meet, a sharper bend than this is a turn into another road, radians: 40 degrees.</summary>
    private const double MaxBendAtJunction = 0.7;

    /// <summary>The penalty of a change of lanes when pairs compete, as an angle, radians.</summary>
    private const double BendOfChangedLanes = 0.3;

    private readonly RoadNetwork _network;
    private readonly int[] _atStart;
    private readonly int[] _atEnd;

    /// <summary>Pairs the links of a network.</summary>
    public RoadContinuations(RoadNetwork network)
    {
        _network = Guard.NotNull(network, nameof(network));
        _atStart = new int[network.Links.Count];
        _atEnd = new int[network.Links.Count];
        for (int i = 0; i < _atStart.Length; i++)
        {
            _atStart[i] = None;
            _atEnd[i] = None;
        }

        for (int node = 0; node < network.Nodes.Count; node++)
        {
            PairAt(node);
        }
    }

    /// <summary>Whether cars drive a link along its own line: it has lanes, is no shortcut, and both its ends are on the road.</summary>
    public static bool IsDrivable(RoadNetwork network, RoadLink link) =>
        Guard.NotNull(link, nameof(link)).LanesForward + link.LanesBackward > 0
        && (link.Flags & (RoadLinkFlags.Shortcut | RoadLinkFlags.DontUseForNavigation)) == 0
        && ((Guard.NotNull(network, nameof(network)).Nodes[link.From].Flags | network.Nodes[link.To].Flags) & OffTheRoad) == 0;

    /// <summary>The link that continues a road, or <see cref="None"/>.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="beyondEnd">True beyond its end, false beyond its start.</param>
    public int Of(int link, bool beyondEnd) => beyondEnd ? _atEnd[link] : _atStart[link];

    private void PairAt(int node)
    {
        var drivable = new List<int>();
        foreach (int link in _network.LinksOf(node))
        {
            if (IsDrivable(_network, _network.Links[link]))
            {
                drivable.Add(link);
            }
        }

        var pairs = new List<(double Cost, int A, int B)>();
        double sharpest = drivable.Count == 2 ? MaxBend : MaxBendAtJunction;
        for (int i = 0; i < drivable.Count; i++)
        {
            for (int j = i + 1; j < drivable.Count; j++)
            {
                RoadLink into = Towards(node, drivable[i]);
                RoadLink onwards = Towards(node, drivable[j]).Reversed();
                double bend = Bend(into, onwards);
                if (bend <= sharpest && CanBeDriven(into, onwards))
                {
                    bool sameLanes = into.LanesForward == onwards.LanesForward && into.LanesBackward == onwards.LanesBackward;
                    pairs.Add((bend + (sameLanes ? 0 : BendOfChangedLanes), drivable[i], drivable[j]));
                }
            }
        }

        // Greedy matching: the cheapest pair first, each link once; ties go by index.
        pairs.Sort();
        foreach ((_, int a, int b) in pairs)
        {
            if (At(node, a) == None && At(node, b) == None)
            {
                At(node, a) = b;
                At(node, b) = a;
            }
        }
    }

    private static bool CanBeDriven(RoadLink into, RoadLink onwards) =>
        (into.LanesForward > 0 && onwards.LanesForward > 0) || (into.LanesBackward > 0 && onwards.LanesBackward > 0);

    private RoadLink Towards(int node, int link) =>
        _network.Links[link].To == node ? _network.Links[link] : _network.Links[link].Reversed();

    private ref int At(int node, int link)
    {
        if (_network.Links[link].To == node)
        {
            return ref _atEnd[link];
        }

        return ref _atStart[link];
    }

    private double Bend(RoadLink into, RoadLink onwards)
    {
        Vector3D a = _network.Nodes[into.To].Position - _network.Nodes[into.From].Position;
        Vector3D b = _network.Nodes[onwards.To].Position - _network.Nodes[onwards.From].Position;

        // The angle between both chords from cross and dot product.
        return Math.Abs(Math.Atan2((a.X * b.Y) - (a.Y * b.X), (a.X * b.X) + (a.Y * b.Y)));
    }
}
