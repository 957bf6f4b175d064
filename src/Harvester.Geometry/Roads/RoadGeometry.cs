namespace Harvester.Geometry.Roads;

/// <summary>
/// The position of lanes relative to the line between nodes, as in the games of this series. The line runs in the middle of the median, or
/// on the divider if there is none; a one-way road is centred on it. Offsets are metres to the right of the line, looking from start to end
/// of the link.
/// </summary>
public static class RoadGeometry
{
    /// <summary>Width of a lane of an ordinary road, metres: the constant of the series' engine.</summary>
    public const double LaneWidth = 5.4;

    /// <summary>Width of a lane of a road marked as narrow, metres.</summary>
    public const double NarrowLaneWidth = 4.0;

    /// <summary>The width of a link's lanes according to the constants, metres.</summary>
    public static double LaneWidthOf(RoadLink link) =>
        (Guard.NotNull(link, nameof(link)).Flags & RoadLinkFlags.NarrowRoad) != 0 ? NarrowLaneWidth : LaneWidth;

    /// <summary>
    /// Offset of a marking of the forward direction: marking 0 is the left edge of its leftmost lane, marking n the right edge of its n-th
    /// lane. For a one-way road driven backwards, and for the other direction, call it with the link reversed.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The marking is not from 0 to the number of forward lanes.</exception>
    public static double MarkingOffset(RoadLink link, int marking, double laneWidth)
    {
        Guard.NotNull(link, nameof(link));
        if (marking < 0 || marking > link.LanesForward)
        {
            throw new ArgumentOutOfRangeException(nameof(marking), marking, "A direction has the markings 0 to its number of lanes.");
        }

        return LeftEdge(link.LanesForward, link.LanesBackward, link.MedianWidth, laneWidth) + (marking * laneWidth);
    }

    internal static double LeftEdge(int lanes, int oncomingLanes, double? medianWidth, double laneWidth) =>
        oncomingLanes > 0 ? (medianWidth ?? 0) / 2 : -lanes * laneWidth / 2;
}
