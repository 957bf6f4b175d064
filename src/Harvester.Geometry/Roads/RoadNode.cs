namespace Harvester.Geometry.Roads;

/// <summary>A node of the road network.</summary>
/// <param name="Area">Number of the cell of the game's path files that contains the node; <see cref="NoArea"/> for a source without
/// cells.</param>
/// <param name="Number">Number of the node within its cell; for a source without cells, its index in the source.</param>
/// <param name="Position">Metres, world, with the bias of the game's truncated coordinates removed.</param>
/// <param name="Street">Name or hash of the street as the source gives it; empty if there is none.</param>
/// <param name="Flags">The flags of the path data.</param>
public sealed record RoadNode(int Area, int Number, Vector3D Position, string Street, RoadNodeFlags Flags)
{
    /// <summary>The <see cref="Area"/> of nodes from a source without the game's numbers.</summary>
    public const int NoArea = -1;

    /// <summary>Speed of traffic; null if the source does not give it.</summary>
    public RoadSpeed? Speed { get; init; }

    /// <summary>Density of traffic, 0 to 15; null if the source does not give it.</summary>
    public int? Density { get; init; }
}
