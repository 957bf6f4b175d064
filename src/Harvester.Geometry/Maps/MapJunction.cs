namespace Harvester.Geometry.Maps;

/// <summary>
/// A junction: one node where roads meet, or several that links within the junction connect; or a node where a road goes on with other
/// lanes.
/// </summary>
/// <param name="Id">A name that depends on its nodes alone.</param>
/// <param name="Nodes">Indices of its nodes, ascending.</param>
/// <param name="Ways">The ways through it.</param>
public sealed record MapJunction(string Id, IReadOnlyList<int> Nodes, IReadOnlyList<MapLane> Ways);
