using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>A line that bounds one lane, or two that lie beside each other.</summary>
/// <param name="kind">What it lies between.</param>
/// <param name="points">Its points before ends that meet are joined, metres, world.</param>
/// <param name="axis">As many points of the line of its road, or of the middle of its way.</param>
/// <param name="start">The place at which it starts, a number of <see cref="MeetingPoints"/>.</param>
/// <param name="end">The place at which it ends.</param>
internal sealed class LaneBorder(LaneBorderKind kind, IReadOnlyList<Vector3D> points, IReadOnlyList<Vector3D> axis, int start, int end)
{
    /// <summary>What it lies between.</summary>
    public LaneBorderKind Kind { get; set; } = kind;

    public IReadOnlyList<Vector3D> Points { get; } = points;

    public IReadOnlyList<Vector3D> Axis { get; } = axis;

    public int Start { get; } = start;

    public int End { get; } = end;

    /// <summary>How it is painted; null if that is unknown.</summary>
    public MapMarking? Marking { get; set; }

    /// <summary>Its nodes, numbers of <see cref="LaneBorders.Nodes"/>.</summary>
    public IReadOnlyList<int> Nodes { get; set; } = [];
}
