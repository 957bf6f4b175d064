using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Eight vectors or colours, component by component. Every element is rounded as it would be alone, so results are the same on every
/// processor.
/// </summary>
internal readonly struct WideVector(Vector256<float> x, Vector256<float> y, Vector256<float> z)
{
    public readonly Vector256<float> X = x;
    public readonly Vector256<float> Y = y;
    public readonly Vector256<float> Z = z;

    /// <summary>One vector eight times.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector Of(Vector3 vector) => new(Vector256.Create(vector.X), Vector256.Create(vector.Y), Vector256.Create(vector.Z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator +(in WideVector a, in WideVector b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator -(in WideVector a, in WideVector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator *(in WideVector a, in WideVector b) => new(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static WideVector operator *(in WideVector a, Vector256<float> factor) => new(a.X * factor, a.Y * factor, a.Z * factor);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> Dot(in WideVector other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    /// <summary>A fraction of the way to another.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WideVector Towards(in WideVector other, Vector256<float> fraction) => this + ((other - this) * fraction);
}
