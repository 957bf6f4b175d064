using Harvester.Geometry;

namespace Harvester.Datasets.Logs;

/// <summary>A part of a log's map.</summary>
/// <param name="Id">Its number, which no other feature of the log has.</param>
/// <param name="Kind">What it is.</param>
/// <param name="Type">WOMD's number of its type: of a lane 1 freeway, 2 street, 3 bicycles; of a line its paint, 1 to 8; of an edge 1
/// the road's, 2 a median's; 0 if it is unknown and for others.</param>
/// <param name="Points">Metres, world.</param>
internal sealed record LogFeature(long Id, LogFeatureKind Kind, int Type, IReadOnlyList<Vector3D> Points)
{
    /// <summary>Of a lane, those that lead into it.</summary>
    public IReadOnlyList<long> Entries { get; init; } = [];

    /// <summary>Of a lane, those that continue it.</summary>
    public IReadOnlyList<long> Exits { get; init; } = [];

    /// <summary>Of a lane, those beside it on the left in the same direction.</summary>
    public IReadOnlyList<long> LeftNeighbours { get; init; } = [];

    /// <summary>Of a lane, those beside it on the right in the same direction.</summary>
    public IReadOnlyList<long> RightNeighbours { get; init; } = [];

    /// <summary>Of a lane, the lines and edges along its left.</summary>
    public IReadOnlyList<long> LeftBoundaries { get; init; } = [];

    /// <summary>Of a lane, the lines and edges along its right.</summary>
    public IReadOnlyList<long> RightBoundaries { get; init; } = [];

    /// <summary>Whether a lane leads through a junction.</summary>
    public bool IsWay { get; init; }

    /// <summary>Of a stop sign, the lanes that it governs.</summary>
    public IReadOnlyList<long> Lanes { get; init; } = [];
}
