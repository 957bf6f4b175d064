namespace Harvester.Geometry.Maps;

/// <summary>A traffic light or sign of the world.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Model">Name of its model; empty if unknown.</param>
/// <param name="Position">Its origin, metres, world: the foot of its pole.</param>
/// <param name="Facing">The direction in which its lenses or its face look, against the traffic; of any length, not vertical.</param>
public sealed record MapProp(MapSignalKind Kind, string Model, Vector3D Position, Vector3D Facing);
