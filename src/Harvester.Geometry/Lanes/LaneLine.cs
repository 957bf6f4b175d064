using System.Collections.Generic;

namespace Harvester.Geometry.Lanes;

/// <summary>A marking of a road as a line in the world.</summary>
/// <param name="Index">
/// Number of the marking. Of the car's direction: 0 is the left edge of its leftmost lane, n the right edge of its n-th. Of the other
/// direction: -1 is the edge of its lanes at the median, -2 the next to the left of the car, and so on; where there is no median, -1
/// would lie on 0 and is left out.
/// </param>
/// <param name="IsLeftOfCar">Whether it lies to the left of the car.</param>
/// <param name="Points">Points along it, nearest first, metres, world.</param>
public sealed record LaneLine(int Index, bool IsLeftOfCar, IReadOnlyList<Vector3D> Points);
