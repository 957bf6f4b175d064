namespace Harvester.Geometry.Roads;

/// <summary>
/// The database of nodes that the thesis proposes: every node once for each direction in which cars leave it, and for each in which they
/// arrive where no road continues. Directions are the tangents of the smooth centre lines. The confidence is a grade, not a probability: 1
/// for a calibrated width and 0.8 for a constant, times 0.8 if a two-way road's median is unknown, times 0.5 at a junction.
/// </summary>
public sealed class NodeDatabase
{
    private const double ConstantWidth = 0.8;
    private const double UnknownMedian = 0.8;
    private const double AtJunction = 0.5;

    private readonly RoadCurves _curves;
    private readonly LaneModel _lanes;

    /// <summary>Creates the database from the centre lines and lane widths of a network.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">The widths of the lanes.</param>
    public NodeDatabase(RoadCurves curves, LaneModel lanes)
    {
        _curves = Guard.NotNull(curves, nameof(curves));
        _lanes = Guard.NotNull(lanes, nameof(lanes));
    }

    /// <summary>The entries in the order of the nodes, and at each node in the order of its links.</summary>
    public IEnumerable<NodeDatabaseEntry> Entries()
    {
        RoadNetwork network = _curves.Network;
        for (int node = 0; node < network.Nodes.Count; node++)
        {
            foreach (int link in network.LinksOf(node))
            {
                RoadLink road = network.Links[link];
                if (!RoadContinuations.IsDrivable(network, road))
                {
                    continue;
                }

                bool leavesForward = road.From == node;
                if ((leavesForward ? road.LanesForward : road.LanesBackward) > 0)
                {
                    yield return Entry(node, link, leavesForward);
                }

                bool goesOn = _curves.Continuations.Of(link, beyondEnd: !leavesForward) != RoadContinuations.None;
                if (!goesOn && (leavesForward ? road.LanesBackward : road.LanesForward) > 0)
                {
                    yield return Entry(node, link, !leavesForward);
                }
            }
        }
    }

    private NodeDatabaseEntry Entry(int node, int link, bool isForward)
    {
        RoadNetwork network = _curves.Network;
        RoadNode place = network.Nodes[node];
        RoadLink road = isForward ? network.Links[link] : network.Links[link].Reversed();
        bool isStart = network.Links[link].From == node;
        RoadCurve curve = _curves.Of(link);
        Vector2D along = curve.DirectionAt(isStart ? 0 : 1) * (isForward ? 1 : -1);
        var right = new Vector3D(along.Y, -along.X, 0);
        (double width, LaneWidthSource source) = _lanes.WidthOf(link, isForward, isStart ? 0 : curve.Length);
        bool oneWay = road.IsOneWay;
        double innerEdge = oneWay ? 0 : (road.MedianWidth ?? 0) / 2;
        double rightEdge = RoadGeometry.MarkingOffset(road, road.LanesForward, width);
        double leftEdge = oneWay ? rightEdge : innerEdge + (road.LanesBackward * width);
        bool isJunction = JunctionExtents.IsJunction(network, node);
        return new NodeDatabaseEntry
        {
            Node = node,
            NodeId = place.Area == RoadNode.NoArea ? null : ((long)place.Number << 16) + place.Area + 1,
            OnMarking = oneWay ? road.LanesForward % 2 == 0 : innerEdge == 0,
            OneWay = oneWay,
            LeftStart = place.Position - (right * innerEdge),
            LeftEnd = place.Position - (right * leftEdge),
            RightStart = place.Position + (right * innerEdge),
            RightEnd = place.Position + (right * rightEdge),
            Heading = new Vector3D(along.X, along.Y, 0),
            Lanes = road.LanesForward,
            OncomingLanes = road.LanesBackward,
            LaneWidth = width,
            LaneWidthSource = source,
            MedianWidth = road.MedianWidth,
            Confidence =
                (source == LaneWidthSource.Calibrated ? 1 : ConstantWidth)
                * (road.MedianWidth is null && !oneWay ? UnknownMedian : 1)
                * (isJunction ? AtJunction : 1),
            IsJunction = isJunction,
        };
    }
}
