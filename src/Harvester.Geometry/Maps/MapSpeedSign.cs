namespace Harvester.Geometry.Maps;

/// <summary>A sign with a speed limit.</summary>
/// <param name="Limit">Metres per second.</param>
/// <param name="Position">Its origin, metres, world: the foot of its pole.</param>
/// <param name="Facing">The direction in which its face looks, against the traffic; of any length, not vertical.</param>
public sealed record MapSpeedSign(double Limit, Vector3D Position, Vector3D Facing);
