using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// A matrix stored by columns, for many points: computes all four homogeneous coordinates of a point at once, rounded as <see
/// cref="Matrix4.Transform"/> rounds them.
/// </summary>
internal readonly struct ClipTransform(in Matrix4 matrix)
{
    private readonly Vector256<double> _x = Vector256.Create(matrix.Row0.X, matrix.Row1.X, matrix.Row2.X, matrix.Row3.X);
    private readonly Vector256<double> _y = Vector256.Create(matrix.Row0.Y, matrix.Row1.Y, matrix.Row2.Y, matrix.Row3.Y);
    private readonly Vector256<double> _z = Vector256.Create(matrix.Row0.Z, matrix.Row1.Z, matrix.Row2.Z, matrix.Row3.Z);
    private readonly Vector256<double> _shift = Vector256.Create(matrix.Row0.W, matrix.Row1.W, matrix.Row2.W, matrix.Row3.W);

    /// <summary>What a step along x changes.</summary>
    public Vector256<double> AlongX(double step) => _x * step;

    /// <summary>What a step along y changes.</summary>
    public Vector256<double> AlongY(double step) => _y * step;

    /// <summary>What a step along z changes.</summary>
    public Vector256<double> AlongZ(double step) => _z * step;

    public Vector256<double> Apply(Vector3D point) => (_x * point.X) + (_y * point.Y) + (_z * point.Z) + _shift;
}
