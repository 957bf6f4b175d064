#if NET
using System.Runtime.Intrinsics;

namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>Arithmetic on eight integers side by side.</summary>
internal readonly struct VectorLanes : ILanes<Vector256<int>>
{
    public Vector256<int> Sum(Vector256<int> left, Vector256<int> right) => left + right;

    public Vector256<int> Difference(Vector256<int> left, Vector256<int> right) => left - right;

    public Vector256<int> Product(Vector256<int> value, int factor) => value * Vector256.Create(factor);

    public Vector256<int> ShiftedLeft(Vector256<int> value, int bits) => value << bits;

    public Vector256<int> Rounded(Vector256<int> value, int bits) => (value + Vector256.Create(1 << (bits - 1))) >> bits;
}
#endif
