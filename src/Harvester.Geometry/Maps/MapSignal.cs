namespace Harvester.Geometry.Maps;

/// <summary>A traffic light or a sign, and the lanes that it governs.</summary>
/// <param name="Id">A name that depends on its kind and place alone.</param>
/// <param name="Kind">What it is.</param>
/// <param name="Position">Its origin, metres, world: the foot of its pole.</param>
/// <param name="Facing">Unit vector on the ground of the direction in which it looks, against the traffic.</param>
/// <param name="Model">Name of its model; empty if unknown.</param>
/// <param name="Lanes">The lanes that it governs, from left to right; empty if it faces none. They end at a junction.</param>
public sealed record MapSignal(
    string Id,
    MapSignalKind Kind,
    Vector3D Position,
    Vector3D Facing,
    string Model,
    IReadOnlyList<MapLane> Lanes
)
{
    /// <summary>Where its traffic waits; null if it governs no lane.</summary>
    public MapStopLine? StopLine { get; internal set; }
}
