using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>The ground below bodies that follow no lane: that of the nearest lane, or level ground where there is none.</summary>
internal sealed class GroundBelow(LaneGraph lanes)
{
    private readonly LaneFinder _finder = new(lanes);

    /// <summary>The lanes beside which a place on the ground lies, from the nearest on.</summary>
    public List<LanePlace> Lanes(Vector3D place) =>
        [.. _finder.Near(place).OrderBy(near => Math.Abs(near.RightOffset)).ThenBy(near => near.Path.Index)];

    /// <summary>Height of the ground, metres, and its rise per metre in a direction.</summary>
    /// <param name="near">The lanes there.</param>
    /// <param name="direction">Horizontal unit vector.</param>
    /// <param name="before">The height where there is no lane.</param>
    public static (double Height, double Slope) At(IReadOnlyList<LanePlace> near, Vector3D direction, double before)
    {
        if (near.Count == 0)
        {
            return (before, 0);
        }

        LanePlace place = near[0];
        Vector3D tangent = place.Path.Line.TangentAt(place.Distance);
        double slope = tangent.Z / Math.Sqrt(1 - (tangent.Z * tangent.Z)) * Math.Cos(Horizontal.Turn(tangent, direction));
        return (place.Path.Line.PositionAt(place.Distance).Z, slope);
    }
}
