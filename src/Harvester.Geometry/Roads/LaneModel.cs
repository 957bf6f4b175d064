namespace Harvester.Geometry.Roads;

/// <summary>
/// The width of the lanes of each road and where they begin: as its painted lines were measured, else calibrated by the edges of the road
/// where a game reports them consistently, and otherwise by constants that can be chosen. Edges establish a width if both edges of the
/// link were reported twice, lie perpendicular
/// to it on either side, and all give the same width between 3 and 7 m. Immutable.
/// </summary>
public sealed class LaneModel
{
    private readonly RoadNetwork _network;
    private readonly double _laneWidth;
    private readonly double _narrowLaneWidth;
    private readonly IReadOnlyDictionary<(int Link, bool IsForward), MeasuredLanes> _measured;
    private readonly Dictionary<int, double> _calibrated = [];

    /// <summary>Creates the model of a network's lane widths.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="laneWidth">Width of the lanes of an ordinary road, metres; greater than 0.</param>
    /// <param name="narrowLaneWidth">Width of the lanes of a narrow road, metres; greater than 0.</param>
    /// <param name="measured">Lanes measured from paint, by link and direction (true from start to end); null for none.</param>
    public LaneModel(
        RoadNetwork network,
        double laneWidth = RoadGeometry.LaneWidth,
        double narrowLaneWidth = RoadGeometry.NarrowLaneWidth,
        IReadOnlyDictionary<(int Link, bool IsForward), MeasuredLanes>? measured = null
    )
    {
        _measured = measured ?? new Dictionary<(int Link, bool IsForward), MeasuredLanes>();
        _network = Guard.NotNull(network, nameof(network));
        _laneWidth = Guard.Positive(laneWidth, nameof(laneWidth));
        _narrowLaneWidth = Guard.Positive(narrowLaneWidth, nameof(narrowLaneWidth));
        foreach (IGrouping<int, RoadEdge> edges in network.Edges.GroupBy(static edge => edge.Link))
        {
            if (EdgeEvidence.LaneWidth(network, network.Links[edges.Key], [.. edges]) is { } width)
            {
                _calibrated.Add(edges.Key, width);
            }
        }
    }

    /// <summary>Mean width of the lanes of one direction of a link, metres, and its source.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">True for the direction from start to end, false for the opposite one.</param>
    /// <param name="station">Metres along the link's curve from its start; only measured lanes change along a link.</param>
    public (double Width, LaneWidthSource Source) WidthOf(int link, bool isForward, double station)
    {
        if (_measured.TryGetValue((link, isForward), out MeasuredLanes? lanes))
        {
            MeasuredSection measured = lanes.At(station);
            return (measured.Section.LaneWidth, measured.IsWhole ? LaneWidthSource.Paint : LaneWidthSource.PartlyPaint);
        }

        if (_calibrated.TryGetValue(link, out double width))
        {
            return (width, LaneWidthSource.Calibrated);
        }

        return (_network.Links[link].Flags & RoadLinkFlags.NarrowRoad) != 0
            ? (_narrowLaneWidth, LaneWidthSource.NarrowConstant)
            : (_laneWidth, LaneWidthSource.Constant);
    }

    /// <summary>The lanes of one direction of a link, and the left edge of the leftmost.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">True for the direction from start to end, false for the opposite one.</param>
    /// <param name="station">Metres along the link's curve from its start; only measured lanes change along a link.</param>
    /// <returns>The lanes and the offset of their left edge, metres to the right of the line in that direction; null if there are no
    /// lanes.</returns>
    public (LaneSection Section, double LeftEdge)? LanesOf(int link, bool isForward, double station)
    {
        RoadLink road = _network.Links[link];
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        if (lanes == 0)
        {
            return null;
        }

        if (_measured.TryGetValue((link, isForward), out MeasuredLanes? there))
        {
            MeasuredSection measured = there.At(station);
            return (measured.Section, measured.LeftEdge);
        }

        double width = WidthOf(link, isForward, station).Width;
        int oncomingLanes = isForward ? road.LanesBackward : road.LanesForward;
        return (new LaneSection(lanes, width), RoadGeometry.LeftEdge(lanes, oncomingLanes, road.MedianWidth, width));
    }

    /// <summary>The stations between which the lanes of a link change evenly, metres along its curve from its start, in no order; none if
    /// they do not change.</summary>
    internal IEnumerable<double> StationsOf(int link) => StationsOf(link, isForward: true).Concat(StationsOf(link, isForward: false));

    private IEnumerable<double> StationsOf(int link, bool isForward) =>
        _measured.TryGetValue((link, isForward), out MeasuredLanes? measured) ? measured.Stations : [];

    /// <summary>
    /// Largest offset of the right edge of the lanes of one direction along a link, metres to the right of its line in that direction; null
    /// if there are no lanes.
    /// </summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">True for the direction from start to end, false for the opposite one.</param>
    public double? RightEdgeOf(int link, bool isForward) =>
        _measured.TryGetValue((link, isForward), out MeasuredLanes? measured) ? measured.RightEdge
        : LanesOf(link, isForward, 0) is { } lanes ? lanes.LeftEdge + lanes.Section.Width
        : null;
}
