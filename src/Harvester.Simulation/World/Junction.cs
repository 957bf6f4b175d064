using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.World;

/// <summary>A node at which roads end: a crossing, a change of lane layout or a dead end.</summary>
/// <param name="Node">Number of the network's node.</param>
/// <param name="Position">Metres, world.</param>
/// <param name="Flags">What the network says of the node.</param>
/// <param name="Arms">The road ends that meet here.</param>
internal sealed record Junction(int Node, Vector3D Position, RoadNodeFlags Flags, IReadOnlyList<RoadArm> Arms)
{
    /// <summary>Whether more than two roads meet, so that their areas overlap.</summary>
    public bool IsCrossing => Arms.Count > 2;
}
