namespace Harvester.Geometry.Roads;

/// <summary>
/// The extents of junctions along the links that meet in them. A junction is a node where more than two drivable links meet, or that the
/// path data marks as one. Along each link it extends to where the edge of the carriageway meets those of its neighbours, plus room for
/// corners and stop lines; if a link is shorter than that, the junction extends along the link that continues it.
/// </summary>
public sealed class JunctionExtents
{
    /// <summary>Distance from the crossing of the edges to the first point with lanes of its own, metres: the radius of a corner.</summary>
    private const double CornerRoom = 1.5;

    /// <summary>
    /// Maximum distance from a junction's node to where edges cross, metres. It limits roads that part at so small an angle that their
    /// edges cross far away or never.
    /// </summary>
    private const double MaxReach = 30;

    /// <summary>Roads that meet at a smaller angle than this merge or continue each other and do not cross, radians: 35 degrees.</summary>
    private const double MergingAngle = 0.6;

    /// <summary>Maximum length of a link between two carriageways, metres: enough to cross a median and two lanes at an angle.</summary>
    private const double MaxCrossoverLength = 40;

    private readonly RoadCurves _curves;
    private readonly RoadNetwork _network;
    private readonly LaneModel _lanes;
    private readonly double[] _fromStart;
    private readonly double[] _fromEnd;

    /// <summary>Computes the junctions of a network.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the roads.</param>
    public JunctionExtents(RoadCurves curves, LaneModel lanes)
    {
        _curves = Guard.NotNull(curves, nameof(curves));
        _network = curves.Network;
        _lanes = Guard.NotNull(lanes, nameof(lanes));
        _fromStart = new double[_network.Links.Count];
        _fromEnd = new double[_network.Links.Count];
        for (int node = 0; node < _network.Nodes.Count; node++)
        {
            List<int> arms = DrivableAt(_network, node);
            List<int> roads = [.. arms.Where(arm => !IsCrossover(arm))];
            if (IsJunction(_network, node, roads.Count))
            {
                // Along each road the junction extends to the last corner with another one.
                foreach (int road in roads)
                {
                    Cover(node, road, Reach(node, road, roads));
                }
            }

            // A crossover is a junction from end to end.
            foreach (int tie in arms.Except(roads))
            {
                Cover(node, tie, _curves.Of(tie).Length);
            }
        }
    }

    /// <summary>Whether a node is a junction.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="node">Index of the node.</param>
    public static bool IsJunction(RoadNetwork network, int node) => IsJunction(network, node, DrivableAt(network, node).Count);

    /// <summary>
    /// The extents of the junctions at the start and at the end of a link, metres; 0 if there is no junction, more than the link's length
    /// if it lies within one.
    /// </summary>
    /// <param name="link">Index of the link.</param>
    public (double FromStart, double FromEnd) Of(int link) => (_fromStart[link], _fromEnd[link]);

    /// <summary>Whether a point on a link lies in a junction.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="station">Metres from the link's start.</param>
    public bool Contains(int link, double station) => station < _fromStart[link] || station > _curves.Of(link).Length - _fromEnd[link];

    private static bool IsJunction(RoadNetwork network, int node, int arms) =>
        arms > 2 || (arms > 0 && (network.Nodes[node].Flags & RoadNodeFlags.Junction) != 0);

    private static List<int> DrivableAt(RoadNetwork network, int node)
    {
        var links = new List<int>();
        foreach (int link in network.LinksOf(node))
        {
            if (RoadContinuations.IsDrivable(network, network.Links[link]))
            {
                links.Add(link);
            }
        }

        return links;
    }

    /// <summary>
    /// Whether a link only connects two carriageways that run side by side, so that cars can change over: roads that continue there have
    /// their lanes beside it. It lies between lanes itself, and counts as a junction from end to end.
    /// </summary>
    private bool IsCrossover(int link)
    {
        RoadLink road = _network.Links[link];
        return _curves.Of(link).Length <= MaxCrossoverLength
            && DirectionThrough(road.From, link) is { } here
            && DirectionThrough(road.To, link) is { } there
            // Parallel either way: |sin| of the angle between both roads is small for 0° and for 180°.
            && Math.Abs(here.Cross(there)) < Math.Sin(MergingAngle);
    }

    /// <summary>
    /// The direction of the road that continues through a node past a link; null if none does, or the path data marks the node as a
    /// junction.
    /// </summary>
    private Vector2D? DirectionThrough(int node, int link)
    {
        if ((_network.Nodes[node].Flags & RoadNodeFlags.Junction) == 0)
        {
            foreach (int other in DrivableAt(_network, node))
            {
                int next = Next(node, other);
                if (other != link && next != RoadContinuations.None && next != link)
                {
                    return Outward(node, other);
                }
            }
        }

        return null;
    }

    /// <summary>Marks the first metres of a road that leaves a junction, and beyond the end of a link those of the next one.</summary>
    private void Cover(int node, int link, double reach)
    {
        while (true)
        {
            bool leavesForward = _network.Links[link].From == node;

            // What is left of the reach after this link's length goes on along its continuation.
            double[] covered = leavesForward ? _fromStart : _fromEnd;
            covered[link] = Math.Max(covered[link], reach);
            reach -= _curves.Of(link).Length;
            node = leavesForward ? _network.Links[link].To : _network.Links[link].From;
            link = _curves.Continuations.Of(link, beyondEnd: leavesForward);
            if (reach <= 0 || link == RoadContinuations.None)
            {
                return;
            }
        }
    }

    /// <summary>
    /// The last corner of a link with a neighbour, metres along it: two edges a and b beside lines that part at an angle t cross (b + a cos
    /// t) / sin t from the lines' common point.
    /// </summary>
    private double Reach(int node, int link, List<int> arms)
    {
        Vector2D along = Outward(node, link);
        bool goesOn = GoesOn(node, link);
        double reach = 0;
        foreach (int other in arms)
        {
            Vector2D beside = Outward(node, other);

            // Angle from this road to the other, positive to the left. Roads that merge and roads that go straight on have no corner.
            double angle = Math.Atan2(along.Cross(beside), along.Dot(beside));
            bool isMerging = Math.Abs(angle) < MergingAngle && goesOn;
            if (other == link || isMerging || Math.Abs(angle) > Math.PI - MergingAngle)
            {
                continue;
            }

            // The edges that face each other meet: this road's on the side of the other, and the other's on the opposite side as seen along
            // it.
            bool isOnLeft = angle > 0;
            double sine = Math.Sin(Math.Abs(angle));
            double corner = Edge(node, other, onLeft: !isOnLeft) + (Edge(node, link, isOnLeft) * Math.Cos(angle));

            // corner / sin t, cut off at MaxReach without dividing by a sine near 0.
            reach = Math.Max(reach, CornerRoom + (corner < MaxReach * sine ? corner / sine : MaxReach));
        }

        return reach;
    }

    /// <summary>Whether a road continues through a node with its lanes; the lanes of a road that merges end there instead.</summary>
    private bool GoesOn(int node, int link)
    {
        // Both links in the direction through the node, so that forward means the same for both.
        RoadLink road = _network.Links[link].To == node ? _network.Links[link] : _network.Links[link].Reversed();
        int next = Next(node, link);
        if (next == RoadContinuations.None)
        {
            return false;
        }

        RoadLink onwards = _network.Links[next].From == node ? _network.Links[next] : _network.Links[next].Reversed();
        return road.LanesForward == onwards.LanesForward && road.LanesBackward == onwards.LanesBackward;
    }

    /// <summary>The link that continues a link beyond a node.</summary>
    private int Next(int node, int link) => _curves.Continuations.Of(link, beyondEnd: _network.Links[link].To == node);

    private Vector2D Outward(int node, int link)
    {
        bool isStart = _network.Links[link].From == node;
        return _curves.Of(link).DirectionAt(isStart ? 0 : 1) * (isStart ? 1 : -1);
    }

    /// <summary>Distance of an edge of a link's carriageway from its line, looking away from a node, metres.</summary>
    private double Edge(int node, int link, bool onLeft)
    {
        bool looksForward = _network.Links[link].From == node;
        bool keepsRight = !onLeft;
        double station = looksForward ? 0 : _curves.Of(link).Length;
        if (_lanes.LanesOf(link, looksForward == keepsRight, station) is { } lanes)
        {
            return lanes.LeftEdge + lanes.Section.Width;
        }

        // A one-way road driven the other way: it is as wide on either side of its line.
        return _lanes.LanesOf(link, looksForward != keepsRight, station) is { } oneWay ? -oneWay.LeftEdge : 0;
    }
}
