using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Four vectors of double precision, component by component. Every element is rounded as it would be alone, in the order of operations of
/// <see cref="Vector3D"/>.
/// </summary>
internal readonly struct QuadVector(Vector256<double> x, Vector256<double> y, Vector256<double> z)
{
    public readonly Vector256<double> X = x;
    public readonly Vector256<double> Y = y;
    public readonly Vector256<double> Z = z;

    /// <summary>One vector four times.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static QuadVector Of(Vector3D vector) => new(Vector256.Create(vector.X), Vector256.Create(vector.Y), Vector256.Create(vector.Z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static QuadVector operator -(in QuadVector a, in QuadVector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<double> Dot(in QuadVector other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public QuadVector Cross(in QuadVector other) =>
        new((Y * other.Z) - (Z * other.Y), (Z * other.X) - (X * other.Z), (X * other.Y) - (Y * other.X));

    /// <summary>The same vectors with another one at a place.</summary>
    public QuadVector With(int place, Vector3D vector) =>
        new(X.WithElement(place, vector.X), Y.WithElement(place, vector.Y), Z.WithElement(place, vector.Z));
}
