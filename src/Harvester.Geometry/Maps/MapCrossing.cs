namespace Harvester.Geometry.Maps;

/// <summary>A pedestrian crossing.</summary>
/// <param name="Id">A name that depends on its place alone.</param>
/// <param name="Corners">Its outline, metres, world, counter-clockwise seen from above; at least three corners.</param>
/// <param name="Source">Measured or known if it is painted; derived where nodes of the road data say that pedestrians cross.</param>
public sealed record MapCrossing(string Id, IReadOnlyList<Vector3D> Corners, MapSource Source);
