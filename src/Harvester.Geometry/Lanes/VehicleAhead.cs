namespace Harvester.Geometry.Lanes;

/// <summary>A vehicle in a lane of the car's own direction.</summary>
/// <param name="Lane">Its lane, 0 the leftmost.</param>
/// <param name="Distance">Along the road between the reference points of the two cars, metres; greater than 0 ahead.</param>
public readonly record struct VehicleAhead(int Lane, double Distance);
