using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.Events;

/// <summary>A lane of the town outside junctions, or a way through one.</summary>
/// <param name="road">The road; null for a way, and for a lane between junctions that are one.</param>
/// <param name="isForward">Whether the lane's direction is that of the road's line.</param>
/// <param name="number">Number of the lane from the left.</param>
/// <param name="points">Its middle, metres, world.</param>
/// <param name="startWidth">Its width at its start, metres.</param>
/// <param name="endWidth">Its width at its end, metres.</param>
internal sealed class TownLane(Road? road, bool isForward, int number, IReadOnlyList<Vector3D> points, double startWidth, double endWidth)
{
    public Road? Road => road;

    public bool IsForward => isForward;

    public int Number => number;

    public IReadOnlyList<Vector3D> Points => points;

    public double StartWidth => startWidth;

    public double EndWidth => endWidth;
}
