using System;

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
        int column = (int)left;
        int row = (int)below;
        float low = Mix(Hash(column, row), Hash(column + 1, row), u);
        float high = Mix(Hash(column, row + 1), Hash(column + 1, row + 1), u);
        return Mix(low, high, v);
    }

    /// <summary>A value from 0 to 1 for a whole-numbered place.</summary>
    public static float Hash(int x, int y)
    {
        uint mixed = ((uint)x * 0x9E3779B1u) ^ ((uint)y * 0x85EBCA77u);
        mixed = (mixed ^ (mixed >> 15)) * 0xC2B2AE3Du;
        mixed = (mixed ^ (mixed >> 13)) * 0x27D4EB2Fu;
        return ((mixed ^ (mixed >> 16)) & 0xFFFFFF) / (float)0x1000000;
    }

    private static float Smooth(float t) => t * t * (3 - (2 * t));

    private static float Mix(float a, float b, float t) => a + ((b - a) * t);
}
