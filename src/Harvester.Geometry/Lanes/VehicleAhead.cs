namespace Harvester.Geometry.Lanes;

/// <summary>A vehicle in a lane of the car's own direction.</summary>
/// <param name="Lane">Its lane, 0 the leftmost.</param>
/// <param name="Distance">Along the road from the car's reference point to its, metres; greater than 0 ahead.</param>
public readonly record struct VehicleAhead(int Lane, double Distance);
