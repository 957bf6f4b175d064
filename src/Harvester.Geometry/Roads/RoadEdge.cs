namespace Harvester.Geometry.Roads;

/// <summary>
/// A point on the edge of a road, as a game reported it beside one end of a link. It may be wrong: <see cref="LaneModel"/> checks it.
/// </summary>
/// <param name="Link">Index of the link.</param>
/// <param name="IsAtStart">Whether it lies beside the node where the link starts; otherwise beside the one where it ends.</param>
/// <param name="Point">Metres, world, shifted with its node when the bias of the game's truncated coordinates was removed.</param>
public readonly record struct RoadEdge(int Link, bool IsAtStart, Vector3D Point);
