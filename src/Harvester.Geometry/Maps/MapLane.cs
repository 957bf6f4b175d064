using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// A lane of a road between junctions, or a way through a junction from one lane to another. Points are in the direction of travel,
/// metres, world.
/// </summary>
public sealed class MapLane
{
    private readonly List<MapLane> _successors = [];
    private readonly List<MapLane> _predecessors = [];
    private readonly List<MapSignal> _signals = [];

    internal MapLane(string id) => Id = id;

    /// <summary>A name that depends on the road data alone, so that it is the same in every session.</summary>
    public string Id { get; }

    /// <summary>Index of the link; null in a junction.</summary>
    public int? Link { get; internal init; }

    /// <summary>Whether it runs from the link's start to its end.</summary>
    public bool IsForward { get; internal init; }

    /// <summary>Its number in its direction, 0 the leftmost; in a junction, that of the lane it comes from.</summary>
    public int Index { get; internal init; }

    /// <summary>Index of the junction it leads through; null outside junctions.</summary>
    public int? Junction { get; internal init; }

    /// <summary>Where it leads; null outside junctions.</summary>
    public MapTurn? Turn { get; internal init; }

    /// <summary>The curve of its middle in a junction; null outside junctions, where its road has the curve.</summary>
    public HermiteCurve? Line { get; internal init; }

    /// <summary>Unit vector of its direction on the ground where it begins.</summary>
    public Vector2D StartDirection { get; internal init; }

    /// <summary>Unit vector of its direction on the ground where it ends.</summary>
    public Vector2D EndDirection { get; internal init; }

    /// <summary>Width where it begins, metres.</summary>
    public double StartWidth { get; internal init; }

    /// <summary>Width where it ends, metres.</summary>
    public double EndWidth { get; internal init; }

    /// <summary>Points of its left edge.</summary>
    public IReadOnlyList<Vector3D> Left { get; internal init; } = [];

    /// <summary>Points of its middle, each between those of the edges.</summary>
    public IReadOnlyList<Vector3D> Centre { get; internal init; } = [];

    /// <summary>Points of its right edge.</summary>
    public IReadOnlyList<Vector3D> Right { get; internal init; } = [];

    /// <summary>The lane on its left in the same direction; null if there is none.</summary>
    public MapLane? LeftNeighbour { get; internal set; }

    /// <summary>The lane on its right in the same direction; null if there is none.</summary>
    public MapLane? RightNeighbour { get; internal set; }

    /// <summary>The lane of the other direction on its left; null if there is none, or a median between.</summary>
    public MapLane? Oncoming { get; internal set; }

    /// <summary>The line along its left edge; null if it is unknown.</summary>
    public MapMarking? LeftMarking { get; internal set; }

    /// <summary>The line along its right edge; null if it is unknown.</summary>
    public MapMarking? RightMarking { get; internal set; }

    /// <summary>The speed limit, metres per second; null if it is unknown: the road data has none, only signs
    /// have.</summary>
    public double? SpeedLimit { get; internal set; }

    /// <summary>The stop line across it or at its end; null if there is none.</summary>
    public MapStopLine? StopLine { get; internal set; }

    /// <summary>The lights and signs that govern it; only lanes that end at a junction have some.</summary>
    public IReadOnlyList<MapSignal> Signals => _signals;

    /// <summary>Its place in <see cref="LaneNetwork.Lanes"/>.</summary>
    internal int Order { get; set; }

    /// <summary>The lanes that continue it.</summary>
    public IReadOnlyList<MapLane> Successors => _successors;

    /// <summary>The lanes that it continues.</summary>
    public IReadOnlyList<MapLane> Predecessors => _predecessors;

    /// <summary>Length of its middle on the ground, metres.</summary>
    public double Length
    {
        get
        {
            double length = 0;
            for (int i = 1; i < Centre.Count; i++)
            {
                length += Ground(Centre[i] - Centre[i - 1]).Length;
            }

            return length;
        }
    }

    private static Vector2D Ground(Vector3D vector) => new(vector.X, vector.Y);

    internal void LeadsTo(MapLane next)
    {
        _successors.Add(next);
        next._predecessors.Add(this);
    }

    /// <summary>Forgets the lanes before and after it that a map of an area leaves out.</summary>
    internal void KeepLinks(Predicate<MapLane> isKept)
    {
        _successors.RemoveAll(lane => !isKept(lane));
        _predecessors.RemoveAll(lane => !isKept(lane));
    }

    internal void Add(MapSignal signal) => _signals.Add(signal);
}
