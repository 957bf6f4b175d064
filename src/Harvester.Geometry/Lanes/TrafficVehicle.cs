namespace Harvester.Geometry.Lanes;

/// <summary>A vehicle that may be in a lane of the car's road.</summary>
/// <param name="Id">The caller's number for it.</param>
/// <param name="Position">Centre of its cuboid, metres, world.</param>
/// <param name="HeadingDegrees">Degrees counter-clockwise from north.</param>
/// <param name="Length">Bumper to bumper, metres.</param>
public readonly record struct TrafficVehicle(int Id, Vector3D Position, double HeadingDegrees, double Length);
