namespace Harvester.Geometry.Lanes;

/// <summary>A vehicle ahead on the car's road. Algorithm 5 of the thesis.</summary>
/// <param name="Id">The caller's number for it.</param>
/// <param name="Lane">Its lane, 0 the leftmost of its direction.</param>
/// <param name="IsOncoming">Whether it is in a lane of the other direction; its lane is then counted from the median.</param>
/// <param name="DistanceMetres">Along the road, centre to centre.</param>
/// <param name="BumperDistanceMetres">Along the road, bumper to bumper; negative if the two overlap.</param>
public readonly record struct VehicleInLane(int Id, int Lane, bool IsOncoming, double DistanceMetres, double BumperDistanceMetres);
