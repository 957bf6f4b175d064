using System.Collections.Generic;
using System.Linq;

namespace Harvester.Geometry.Roads;

/// <summary>
/// How wide the lanes of each road are and where they begin: calibrated by the edges of the road where a game tells them and they
/// prove themselves, and by constants that can be chosen elsewhere. An edge proves a width when both edges of the link were told
/// twice, lie square to it on either side, and all give the same width between 3 and 7 m. It does not change once made.
/// </summary>
public sealed class LaneModel
{
    private readonly RoadNetwork _network;
    private readonly double _laneWidth;
    private readonly double _narrowLaneWidth;
    private readonly Dictionary<int, double> _calibrated = [];

    /// <summary>Makes a model.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="laneWidth">Width of the lanes of an ordinary road, metres; greater than 0.</param>
    /// <param name="narrowLaneWidth">Width of the lanes of a narrow road, metres; greater than 0.</param>
    public LaneModel(RoadNetwork network, double laneWidth = RoadGeometry.LaneWidth, double narrowLaneWidth = RoadGeometry.NarrowLaneWidth)
    {
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

    /// <summary>Width of a link's lanes, metres, and where it comes from.</summary>
    /// <param name="link">Index of the link.</param>
    public (double Width, LaneWidthSource Source) WidthOf(int link)
    {
        if (_calibrated.TryGetValue(link, out double width))
        {
            return (width, LaneWidthSource.Calibrated);
        }

        return (_network.Links[link].Flags & RoadLinkFlags.NarrowRoad) != 0
            ? (_narrowLaneWidth, LaneWidthSource.NarrowConstant)
            : (_laneWidth, LaneWidthSource.Constant);
    }

    /// <summary>The lanes of one direction of a link, and where the leftmost begins.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">From start to end; otherwise from end to start.</param>
    /// <returns>The lanes and the offset of their left edge, metres to the right of the line in that direction; null without
    /// lanes.</returns>
    public (LaneSection Section, double LeftEdge)? LanesOf(int link, bool isForward)
    {
        RoadLink road = _network.Links[link];
        int lanes = isForward ? road.LanesForward : road.LanesBackward;
        if (lanes == 0)
        {
            return null;
        }

        double width = WidthOf(link).Width;
        int oncomingLanes = isForward ? road.LanesBackward : road.LanesForward;
        return (new LaneSection(lanes, width), RoadGeometry.LeftEdge(lanes, oncomingLanes, road.MedianWidth, width));
    }
}
