namespace Harvester.Geometry.Maps;

/// <summary>Where the traffic of lanes waits before a junction.</summary>
/// <param name="Id">A name that depends on its lanes, and if it is painted on its place.</param>
/// <param name="Left">Its left end as the traffic sees it, metres, world.</param>
/// <param name="Right">Its right end.</param>
/// <param name="Lanes">The lanes of one direction that wait there, from left to right: those that it crosses or that end at it.</param>
/// <param name="Source">Measured or known if it is painted; derived where the road data says that traffic waits, or a light or sign
/// does: then it lies where the lanes end.</param>
public sealed record MapStopLine(string Id, Vector3D Left, Vector3D Right, IReadOnlyList<MapLane> Lanes, MapSource Source);
