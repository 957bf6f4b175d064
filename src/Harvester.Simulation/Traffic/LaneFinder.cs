using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Finds the paths at a point, on roads and through junctions.</summary>
internal sealed class LaneFinder
{
    /// <summary>Maximum distance of a path's line from the point, metres.</summary>
    public const double Reach = 12;

    private const double SampleStep = 4;
    private const double SameLevel = 3;

    private readonly BodyIndex<(LanePath Path, double Distance)> _samples = new();

    public LaneFinder(LaneGraph lanes)
    {
        foreach (LanePath path in lanes.Paths)
        {
            for (double distance = 0; distance < path.Length; distance += SampleStep)
            {
                _samples.Add((path, distance), path.Line.PositionAt(distance));
            }
        }
    }

    /// <summary>The positions of a point on all paths beside which it lies, within <see cref="Reach"/>.</summary>
    public IEnumerable<LanePlace> Near(Vector3D point) =>
        _samples
            .Near(point)
            .Where(sample =>
                Horizontal.SquaredDistance(sample.Path.Line.PositionAt(sample.Distance), point)
                < (Reach + SampleStep) * (Reach + SampleStep)
            )
            .GroupBy(sample => sample.Path)
            .Select(samples =>
                LanePlace.Of(
                    samples.Key,
                    point,
                    samples.MinBy(sample => Horizontal.SquaredDistance(sample.Path.Line.PositionAt(sample.Distance), point)).Distance
                )
            )
            .Where(place => place is { Beyond: 0, Height: > -SameLevel and < SameLevel, RightOffset: > -Reach and < Reach });
}
