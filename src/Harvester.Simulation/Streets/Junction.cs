using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Streets;

/// <summary>A node at which roads end: a crossing, a corner, a change of lane layout or a dead end.</summary>
/// <param name="Node">Number of the network's node.</param>
/// <param name="Position">Metres, world.</param>
/// <param name="Flags">The node's flags in the network.</param>
/// <param name="Arms">The road ends that meet here.</param>
internal sealed record Junction(int Node, Vector3D Position, RoadNodeFlags Flags, IReadOnlyList<RoadArm> Arms)
{
    private const double NearlyStraightOn = -0.99;

    /// <summary>Whether more than two roads meet, so that their areas overlap.</summary>
    public bool IsCrossing => Arms.Count > 2;

    /// <summary>Whether it is a bend too sharp for a smooth line.</summary>
    public bool IsCorner => Arms.Count == 2 && Arms[0].Outward.Dot(Arms[1].Outward) > NearlyStraightOn;
}
