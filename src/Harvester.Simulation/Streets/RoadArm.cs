using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>A road's end at a junction.</summary>
/// <param name="Road">The road.</param>
/// <param name="AtStart">Whether the road's start lies at the junction; otherwise its end.</param>
internal readonly record struct RoadArm(Road Road, bool AtStart)
{
    /// <summary>Unit direction away from the junction.</summary>
    public Vector3D Outward => AtStart ? Road.Curve.TangentAt(0) : -Road.Curve.TangentAt(Road.Length);

    public double Trim => Road.TrimAt(AtStart);

    /// <summary>The position on the road at a distance from the junction, metres from the road's start.</summary>
    public double DistanceAt(double fromJunction) => AtStart ? fromJunction : Road.Length - fromJunction;
}
