using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.Ynd;

/// <summary>A cell of path nodes as a file has it.</summary>
/// <param name="File">Name of the file.</param>
/// <param name="Area">Number of the cell.</param>
/// <param name="Nodes">Its nodes with the links that begin there, whose own node is not set yet.</param>
internal sealed record YndCell(string File, int Area, List<(RoadNode Node, IReadOnlyList<YndLink> Links)> Nodes);
