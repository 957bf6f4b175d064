namespace Harvester.Geometry.Roads;

/// <summary>A node of the road network.</summary>
/// <param name="Area">Number of the cell of the game's path files that holds the node; <see cref="NoArea"/> where a source has no
/// cells.</param>
/// <param name="Number">Number of the node within its cell; its place in the source where that has no cells.</param>
/// <param name="Position">Metres, world, free of the bias of the game's truncated coordinates.</param>
/// <param name="Street">Name or hash of the street as the source gives it; empty when it has none.</param>
/// <param name="Flags">What the path data says of it.</param>
public sealed record RoadNode(int Area, int Number, Vector3D Position, string Street, RoadNodeFlags Flags)
{
    /// <summary>The <see cref="Area"/> of nodes of a source that does not have the game's numbers.</summary>
    public const int NoArea = -1;

    /// <summary>How fast traffic drives here; null where the source does not say.</summary>
    public RoadSpeed? Speed { get; init; }

    /// <summary>How dense traffic is here, 0 to 15; null where the source does not say.</summary>
    public int? Density { get; init; }
}
