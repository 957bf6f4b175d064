using System;
using System.Numerics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The sky's colour in any direction: a gradient, the sun or moon, and clouds. Colours are 0 to 1.</summary>
internal sealed class Sky
{
    private readonly Vector3 _sun;
    private readonly Vector3 _sunColour;
    private readonly Vector3 _zenith;
    private readonly Vector3 _cloud;
    private readonly float _clouds;

    public Sky(Lighting lighting)
    {
        _sun = ToSingle(lighting.SunDirection);
        _sunColour = ToLight(lighting.SunColour);
        _zenith = ToLight(lighting.ZenithColour);
        Horizon = ToLight(lighting.HorizonColour);
        _clouds = (float)lighting.CloudFraction;
        _cloud = Vector3.Min(Vector3.One, (ToLight(lighting.AmbientColour) * 1.15f) + (_sunColour * 0.75f));
    }

    /// <summary>The horizon's colour, which fog takes on.</summary>
    public Vector3 Horizon { get; }

    public static Vector3 ToSingle(Vector3D vector) => new((float)vector.X, (float)vector.Y, (float)vector.Z);

    public static Vector3 ToLight(Rgb colour) => new Vector3(colour.Red, colour.Green, colour.Blue) / 255;

    /// <summary>The gradient alone, as a surface mirrors it.</summary>
    public Vector3 GradientAt(Vector3 direction)
    {
        float height = Math.Clamp(direction.Z, 0, 1);
        return Vector3.Lerp(Horizon, _zenith, 1 - ((1 - height) * (1 - height) * (1 - height)));
    }

    /// <summary>All of it.</summary>
    public Vector3 ColourAt(Vector3 direction)
    {
        Vector3 colour = GradientAt(direction);
        float towardsSun = Math.Max(0, Vector3.Dot(direction, _sun));
        float glow = towardsSun > 0.9f ? MathF.Pow(towardsSun, 48) * 0.35f : 0;
        float disc = towardsSun > 0.9996f ? 1 : 0;
        colour += _sunColour * ((glow + disc) * (1 - (_clouds * 0.9f)));
        if (direction.Z > 0.02f && _clouds > 0)
        {
            // A flat layer of cloud: the farther towards the horizon, the smaller it looks, until haze hides it.
            float x = direction.X / direction.Z;
            float y = direction.Y / direction.Z;
            float thickness = (Noise.At(x * 1.3f, y * 1.3f) * 0.6f) + (Noise.At(x * 3.1f, y * 3.1f) * 0.28f)
                + (Noise.At(x * 7.7f, y * 7.7f) * 0.12f);
            float cover = Math.Clamp((thickness - 0.72f + (_clouds * 0.62f)) * 4, 0, 1) * Math.Clamp((direction.Z - 0.02f) * 6, 0, 1);
            colour = Vector3.Lerp(colour, _cloud * (1.06f - (0.3f * thickness)), cover * 0.85f);
        }

        return colour;
    }
}
