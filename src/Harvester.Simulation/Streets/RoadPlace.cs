using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>The position of a point along and beside a road.</summary>
/// <param name="Road">The road.</param>
/// <param name="Distance">Metres from the road's start.</param>
/// <param name="RightOffset">Metres to the right of the road's line.</param>
/// <param name="Height">Metres above the road's line.</param>
internal readonly record struct RoadPlace(Road Road, double Distance, double RightOffset, double Height)
{
    /// <summary>Whether the point lies between the carriageway's edges, extended by a margin.</summary>
    public bool IsOnCarriageway(double margin) =>
        RightOffset > Road.Layout.LeftEdge - margin && RightOffset < Road.Layout.RightEdge + margin;

    /// <summary>Distance from the nearer edge of the carriageway, metres; negative outside it.</summary>
    public double Depth => Math.Min(RightOffset - Road.Layout.LeftEdge, Road.Layout.RightEdge - RightOffset);

    public Vector3D Tangent => Road.Curve.TangentAt(Distance);
}
