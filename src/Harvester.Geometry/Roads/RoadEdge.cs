namespace Harvester.Geometry.Roads;

/// <summary>
/// A point on the edge of a road, as a game told it beside one end of a link. It is what the game said, true or not:
/// <see cref="LaneModel"/> judges it.
/// </summary>
/// <param name="Link">Index of the link.</param>
/// <param name="IsAtStart">Whether it lies beside the node where the link starts; otherwise beside that where it ends.</param>
/// <param name="Point">Metres, world, moved with its node as that was freed of the bias of the game's truncated coordinates.</param>
public readonly record struct RoadEdge(int Link, bool IsAtStart, Vector3D Point);
