using Harvester.Geometry;

namespace Harvester.Driving.Bridge;

/// <summary>Puts the car somewhere, standing.</summary>
/// <param name="Position">Metres, world.</param>
/// <param name="HeadingDegrees">Degrees counter-clockwise from north.</param>
public sealed record ResetMessage(Vector3D Position, double HeadingDegrees) : ClientMessage;
