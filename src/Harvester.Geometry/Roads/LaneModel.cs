using System.Collections.Generic;
using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Roads;

/// <summary>
/// How wide the lanes of each road are and where they begin: by constants that can be chosen, and by calibration from the edges of
/// the road where a game gives them. One thread calibrates; between calibrations any number may ask.
/// </summary>
public sealed class LaneModel
{
    /// <summary>Calibrated widths lie between these, metres; others come from an edge of something else.</summary>
    private const double NarrowestLane = 3;
    private const double WidestLane = 8;

    private readonly RoadNetwork _network;
    private readonly double _laneWidth;
    private readonly double _narrowLaneWidth;
    private readonly Dictionary<int, List<double>> _calibrated = [];

    /// <summary>Makes a model.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="laneWidth">Width of the lanes of an ordinary road, metres; greater than 0.</param>
    /// <param name="narrowLaneWidth">Width of the lanes of a narrow road, metres; greater than 0.</param>
    public LaneModel(RoadNetwork network, double laneWidth = RoadGeometry.LaneWidth, double narrowLaneWidth = RoadGeometry.NarrowLaneWidth)
    {
        _network = Guard.NotNull(network, nameof(network));
        _laneWidth = Guard.Positive(laneWidth, nameof(laneWidth));
        _narrowLaneWidth = Guard.Positive(narrowLaneWidth, nameof(narrowLaneWidth));
    }

    /// <summary>Width of a link's lanes, metres, and where it comes from. Of several calibrations the median counts.</summary>
    /// <param name="link">Index of the link.</param>
    public (double Width, LaneWidthSource Source) WidthOf(int link)
    {
        if (_calibrated.TryGetValue(link, out List<double>? widths))
        {
            int middle = widths.Count / 2;
            return (widths.Count % 2 == 1 ? widths[middle] : (widths[middle - 1] + widths[middle]) / 2, LaneWidthSource.Calibrated);
        }

        return (_network.Links[link].Flags & RoadLinkFlags.NarrowRoad) != 0
            ? (_narrowLaneWidth, LaneWidthSource.NarrowConstant)
            : (_laneWidth, LaneWidthSource.Constant);
    }

    /// <summary>
    /// Takes a measured distance from a link's centre line to the edge of the road on the right of one direction. The lanes of that
    /// direction lie between the median and the edge; those of a one-way road between the edges, of which the line is the middle.
    /// </summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">Whether the edge lies on the right of the way from start to end.</param>
    /// <param name="edgeDistance">Metres.</param>
    /// <returns>Whether it was taken: there are lanes, and they come out between 3 and 8 m wide.</returns>
    public bool Calibrate(int link, bool isForward, double edgeDistance)
    {
        RoadLink road = isForward ? _network.Links[link] : _network.Links[link].Reversed();
        int lanes = road.LanesForward;
        double width = road.LanesBackward > 0
            ? (edgeDistance - ((road.MedianWidth ?? 0) / 2)) / lanes
            : 2 * edgeDistance / lanes;
        if (lanes == 0 || !(width > NarrowestLane && width < WidestLane))
        {
            return false;
        }

        if (!_calibrated.TryGetValue(link, out List<double>? widths))
        {
            widths = [];
            _calibrated.Add(link, widths);
        }

        int place = widths.BinarySearch(width);
        widths.Insert(place < 0 ? ~place : place, width);
        return true;
    }

    /// <summary>The lanes of one direction of a link, and where the leftmost begins.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="isForward">From start to end; otherwise from end to start.</param>
    /// <returns>The lanes and the offset of their left edge, metres to the right of the line in that direction; null without lanes.</returns>
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
