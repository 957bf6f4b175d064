using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>
/// Smooth noise over a plane, the same for the same place, eight places at a time. Places are given relative to a point, so that single
/// precision is enough anywhere.
/// </summary>
internal readonly struct NoisePlane
{
    private const uint PrimeX = 0x9E3779B1u;
    private const uint PrimeY = 0x85EBCA77u;
    private readonly float _scale;
    private readonly uint _cellX;
    private readonly uint _cellY;
    private readonly float _restX;
    private readonly float _restY;

    /// <param name="originX">Where places are counted from.</param>
    /// <param name="originY">Where places are counted from.</param>
    /// <param name="scale">Units of noise per unit of place.</param>
    public NoisePlane(double originX, double originY, double scale)
    {
        _scale = (float)scale;
        (_cellX, _restX) = Split(originX * scale);
        (_cellY, _restY) = Split(originY * scale);
    }

    /// <summary>Values from 0 to 1 that change over about one unit of noise.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<float> At(Vector256<float> x, Vector256<float> y)
    {
        Vector256<float> scale = Vector256.Create(_scale);
        x = (x * scale) + Vector256.Create(_restX);
        y = (y * scale) + Vector256.Create(_restY);
        Vector256<float> left = Vector256.Floor(x);
        Vector256<float> below = Vector256.Floor(y);
        Vector256<float> u = Smooth(x - left);
        Vector256<float> v = Smooth(y - below);

        // Value noise: a hash of each of the four corners of the cell, blended bilinearly with smooth weights 3t² - 2t³. The primes are
        // those of xxHash.
        Vector256<uint> column = (Vector256.ConvertToInt32Native(left).AsUInt32() + Vector256.Create(_cellX)) * PrimeX;
        Vector256<uint> row = (Vector256.ConvertToInt32Native(below).AsUInt32() + Vector256.Create(_cellY)) * PrimeY;
        Vector256<uint> nextColumn = column + Vector256.Create(PrimeX);
        Vector256<uint> nextRow = row + Vector256.Create(PrimeY);
        return Mix(Mix(Hash(column ^ row), Hash(nextColumn ^ row), u), Mix(Hash(column ^ nextRow), Hash(nextColumn ^ nextRow), u), v);
    }

    /// <summary>Values from 0 to 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Hash(Vector256<uint> mixed)
    {
        mixed = (mixed ^ (mixed >>> 15)) * 0xC2B2AE3Du;
        mixed = (mixed ^ (mixed >>> 13)) * 0x27D4EB2Fu;

        // 24 bits are a whole number in single precision too.
        return Vector256.ConvertToSingle(((mixed ^ (mixed >>> 16)) & Vector256.Create(0xFFFFFFu)).AsInt32())
            * Vector256.Create(1f / 0x1000000);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Smooth(Vector256<float> t) => t * t * (Vector256.Create(3f) - (t + t));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Mix(Vector256<float> a, Vector256<float> b, Vector256<float> t) => a + ((b - a) * t);

    private static (uint Cell, float Remainder) Split(double value)
    {
        double cell = Math.Floor(value);
        return (unchecked((uint)(long)cell), (float)(value - cell));
    }
}
