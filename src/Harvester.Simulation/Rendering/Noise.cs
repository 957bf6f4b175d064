using System;
using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>Smooth noise over a plane, the same for the same place.</summary>
internal static class Noise
{
    /// <summary>A value from 0 to 1 that changes over about one unit.</summary>
    public static float At(float x, float y)
    {
        float left = MathF.Floor(x);
        float below = MathF.Floor(y);
        float u = Smooth(x - left);
        float v = Smooth(y - below);
        Vector128<int> corner = Vector128.Create((int)left) + Vector128.Create(0, 1, 0, 1);
        Vector128<int> row = Vector128.Create((int)below) + Vector128.Create(0, 0, 1, 1);
        Vector128<float> values = Hash(corner.AsUInt32(), row.AsUInt32());
        return Mix(Mix(values[0], values[1], u), Mix(values[2], values[3], u), v);
    }

    /// <summary>Values from 0 to 1 for whole-numbered places.</summary>
    private static Vector128<float> Hash(Vector128<uint> x, Vector128<uint> y)
    {
        Vector128<uint> mixed = (x * 0x9E3779B1u) ^ (y * 0x85EBCA77u);
        mixed = (mixed ^ (mixed >>> 15)) * 0xC2B2AE3Du;
        mixed = (mixed ^ (mixed >>> 13)) * 0x27D4EB2Fu;

        // 24 bits are a whole number in single precision too.
        return Vector128.ConvertToSingle(((mixed ^ (mixed >>> 16)) & Vector128.Create(0xFFFFFFu)).AsInt32()) / Vector128.Create(
            (float)0x1000000);
    }

    private static float Smooth(float t) => t * t * (3 - (2 * t));

    private static float Mix(float a, float b, float t) => a + ((b - a) * t);
}
