namespace Harvester.Geometry.Roads;

/// <summary>
/// What the thesis's node database (its Figure 22) says of a road node, looked at in one direction of travel, with what one needs
/// to know to use it. A side's road begins at the point nearest to the node and ends at the outer edge.
/// </summary>
public sealed record NodeDatabaseEntry
{
    /// <summary>Index of the node in the network.</summary>
    public required int Node { get; init; }

    /// <summary>
    /// The game's number of the node: number within the cell * 65536 + cell + 1; null where the source of the roads does not have it.
    /// </summary>
    public required long? NodeId { get; init; }

    /// <summary>Whether the node lies on a lane marking; otherwise it lies in the middle of a lane, or in a median.</summary>
    public required bool OnMarking { get; init; }

    /// <summary>Whether the traffic on both sides of the node moves in the same direction.</summary>
    public required bool OneWay { get; init; }

    /// <summary>Where the road begins left of the node: its nearest point, metres, world.</summary>
    public required Vector3D LeftStart { get; init; }

    /// <summary>Where the road ends left of the node, metres, world.</summary>
    public required Vector3D LeftEnd { get; init; }

    /// <summary>Where the road begins right of the node, metres, world.</summary>
    public required Vector3D RightStart { get; init; }

    /// <summary>Where the road ends right of the node, metres, world.</summary>
    public required Vector3D RightEnd { get; init; }

    /// <summary>Unit vector of the direction of travel on the ground.</summary>
    public required Vector3D Heading { get; init; }

    /// <summary>Lanes in the direction of travel.</summary>
    public required int Lanes { get; init; }

    /// <summary>Lanes of the oncoming traffic.</summary>
    public required int OncomingLanes { get; init; }

    /// <summary>Width of each lane, metres.</summary>
    public required double LaneWidth { get; init; }

    /// <summary>Where the width comes from.</summary>
    public required LaneWidthSource LaneWidthSource { get; init; }

    /// <summary>Width of the median, metres; null where the source does not say, and the edges are as without one.</summary>
    public required double? MedianWidth { get; init; }

    /// <summary>A grade from 0 to 1 of how far the edges can be trusted; see <see cref="NodeDatabase"/>.</summary>
    public required double Confidence { get; init; }

    /// <summary>Whether the node is a junction, where lanes are not defined.</summary>
    public required bool IsJunction { get; init; }
}
