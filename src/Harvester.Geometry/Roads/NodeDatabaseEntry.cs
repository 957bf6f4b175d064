namespace Harvester.Geometry.Roads;

/// <summary>
/// A row of the thesis's node database (its Figure 22): a road node seen in one direction of travel, with further columns needed to use it.
/// The road on a side begins at the point nearest to the node and ends at the outer edge.
/// </summary>
public sealed record NodeDatabaseEntry
{
    /// <summary>Index of the node in the network.</summary>
    public required int Node { get; init; }

    /// <summary>
    /// The game's number of the node: number within the cell * 65536 + cell + 1; null if the source of the roads lacks it.
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

    /// <summary>Width of the median, metres; null if the source does not give it. The edges are then computed without a median.</summary>
    public required double? MedianWidth { get; init; }

    /// <summary>A grade from 0 to 1 of how reliable the edges are; see <see cref="NodeDatabase"/>.</summary>
    public required double Confidence { get; init; }

    /// <summary>Whether the node is a junction, where lanes are not defined.</summary>
    public required bool IsJunction { get; init; }
}
