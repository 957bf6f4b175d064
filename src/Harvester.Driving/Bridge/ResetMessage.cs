using Harvester.Geometry;

namespace Harvester.Driving.Bridge;

/// <summary>Places the car at a position, at rest.</summary>
/// <param name="Position">Metres, world.</param>
/// <param name="HeadingDegrees">Degrees counter-clockwise from north.</param>
public sealed record ResetMessage(Vector3D Position, double HeadingDegrees) : ClientMessage;
