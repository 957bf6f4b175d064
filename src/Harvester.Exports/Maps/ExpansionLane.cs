using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>A lane, or a way through a junction, of a nuScenes map. Metres on the ground, world.</summary>
/// <param name="Id">Its name.</param>
/// <param name="Road">The name of its road or junction.</param>
/// <param name="IsConnector">Whether it leads through a junction.</param>
/// <param name="IsForward">Whether it runs as its road's line.</param>
/// <param name="Index">Its number in its direction, 0 the leftmost.</param>
/// <param name="Left">Points of its left border, in its direction.</param>
/// <param name="Right">Points of its right border.</param>
/// <param name="LeftType">How its left border is painted, as nuScenes calls it.</param>
/// <param name="RightType">How its right border is painted.</param>
/// <param name="TouchesOncoming">Whether its left border is that of the oncoming lane too.</param>
/// <param name="Arcs">Its middle.</param>
/// <param name="Predecessors">The names of the lanes before it.</param>
/// <param name="Successors">The names of the lanes after it.</param>
internal sealed record ExpansionLane(
    string Id,
    string Road,
    bool IsConnector,
    bool IsForward,
    int Index,
    IReadOnlyList<Vector2D> Left,
    IReadOnlyList<Vector2D> Right,
    string LeftType,
    string RightType,
    bool TouchesOncoming,
    IReadOnlyList<LaneArc> Arcs,
    IReadOnlyList<string> Predecessors,
    IReadOnlyList<string> Successors
)
{
    /// <summary>The name of the lanes of its direction on its road.</summary>
    public string Block => BlockOf(Road, IsForward);

    /// <summary>The name of the lanes of a direction on a road.</summary>
    public static string BlockOf(string road, bool isForward) => $"{road}/{(isForward ? 'f' : 'b')}";
}
