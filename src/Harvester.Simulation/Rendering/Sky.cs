using System.Numerics;
using System.Runtime.Intrinsics;
using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The colour of the sky in any direction: a gradient, the sun or moon, and clouds. Colours are 0 to 1.</summary>
internal sealed class Sky
{
    private const float GlowCosine = 0.9f;
    private const float DiscCosine = 0.9996f;
    private const float StarsFrom = 0.7f;
    private const float MinCloudHeight = 0.02f;
    private static readonly NoisePlane Large = new(0, 0, 1.3);
    private static readonly NoisePlane Middle = new(0, 0, 3.1);
    private static readonly NoisePlane Small = new(0, 0, 7.7);
    private static readonly NoisePlane Stars = new(0, 0, 260);

    private readonly Vector3 _sun;
    private readonly Vector3 _sunColour;
    private readonly Vector3 _zenith;
    private readonly Vector3 _cloud;
    private readonly Vector3 _glow;
    private readonly Vector3 _glowDirection;
    private readonly float _stars;
    private readonly float _clouds;

    public Sky(Lighting lighting)
    {
        _sun = ToSingle(lighting.SunDirection);
        _sunColour = ToLight(lighting.SunColour);
        _zenith = ToLight(lighting.ZenithColour);
        Horizon = ToLight(lighting.HorizonColour);
        (_glow, _glowDirection) = (ToLight(lighting.GlowColour), ToSingle(lighting.GlowDirection));
        _clouds = (float)lighting.CloudFraction;
        _stars = Math.Max(0, ((float)lighting.NightFraction - StarsFrom) / (1 - StarsFrom)) * Math.Max(0, 1 - (1.5f * _clouds));
        _cloud = Vector3.Min(Vector3.One, (ToLight(lighting.AmbientColour) * 1.15f) + (_sunColour * 0.75f));
    }

    /// <summary>The colour of the horizon, which is also the colour of the fog.</summary>
    public Vector3 Horizon { get; }

    public static Vector3 ToSingle(Vector3D vector) => new((float)vector.X, (float)vector.Y, (float)vector.Z);

    public static Vector3 ToLight(Rgb colour) => new Vector3(colour.Red, colour.Green, colour.Blue) / 255;

    /// <summary>The gradient alone, as a surface mirrors it.</summary>
    /// <param name="height">The vertical components of unit vectors.</param>
    public WideVector GradientAt(Vector256<float> height)
    {
        Vector256<float> down = Wide.One - Wide.Fraction(height);
        return WideVector.Of(_zenith).Towards(WideVector.Of(Horizon), down * down * down);
    }

    /// <summary>All of it.</summary>
    /// <param name="direction">Unit vectors.</param>
    public WideVector ColourAt(in WideVector direction)
    {
        WideVector colour = GradientAt(direction.Z);
        colour = _glow == Vector3.Zero ? colour : Glowing(colour, direction);
        colour = _stars > 0 ? colour + (WideVector.Of(Vector3.One) * (Vector256.Create(_stars) * StarsAt(direction))) : colour;
        Vector256<float> towardsSun = direction.Dot(WideVector.Of(_sun));
        if (Vector256.GreaterThanAny(towardsSun, Vector256.Create(GlowCosine)))
        {
            colour += WideVector.Of(_sunColour * (1 - (_clouds * 0.9f))) * Shine(towardsSun);
        }

        return _clouds > 0 && Vector256.GreaterThanAny(direction.Z, Vector256.Create(MinCloudHeight)) ? Clouded(colour, direction) : colour;
    }

    /// <summary>The glow of sunrise and sunset: strongest at the horizon, on the sun's side.</summary>
    private WideVector Glowing(in WideVector colour, in WideVector direction)
    {
        Vector256<float> side = Wide.Fraction(
            Vector256.Create(0.5f) + (Vector256.Create(0.5f) * direction.Dot(WideVector.Of(_glowDirection)))
        );
        Vector256<float> down = Wide.One - Wide.Fraction(direction.Z);
        Vector256<float> low = down * down * down;
        return colour + (WideVector.Of(_glow) * (side * side * side * low * low * Vector256.Create(0.8f)));
    }

    /// <summary>Stars, where fine noise on the sides of a cube around the eye is high.</summary>
    private static Vector256<float> StarsAt(in WideVector direction)
    {
        Vector256<float> across = Vector256.Abs(direction.X);
        Vector256<float> along = Vector256.Abs(direction.Y);
        Vector256<float> isAcross = Vector256.GreaterThan(across, along);
        Vector256<float> scale = Wide.One / Vector256.ConditionalSelect(isAcross, across, along);
        Vector256<float> side = Vector256.ConditionalSelect(isAcross, direction.Y, direction.X) * scale;
        Vector256<float> star = (Stars.At(side, direction.Z * scale) - Vector256.Create(0.9f)) * Vector256.Create(10f);
        return Wide.Fraction(star) * Wide.Fraction(direction.Z * Vector256.Create(4f));
    }

    /// <summary>The sun's glow and disc.</summary>
    private static Vector256<float> Shine(Vector256<float> towardsSun)
    {
        // The 48th power.
        Vector256<float> power = towardsSun * towardsSun * towardsSun;
        for (int doubling = 0; doubling < 4; doubling++)
        {
            power *= power;
        }

        Vector256<float> glow = Vector256.GreaterThan(towardsSun, Vector256.Create(GlowCosine)) & (power * Vector256.Create(0.35f));
        return glow + (Vector256.GreaterThan(towardsSun, Vector256.Create(DiscCosine)) & Wide.One);
    }

    /// <summary>A flat layer of cloud: the farther towards the horizon, the smaller it looks, until haze hides it.</summary>
    private WideVector Clouded(in WideVector colour, in WideVector direction)
    {
        // The line of sight meets a level layer at unit height at direction / height.
        Vector256<float> height = Vector256.MaxNative(direction.Z, Vector256.Create(MinCloudHeight));
        Vector256<float> x = direction.X / height;
        Vector256<float> y = direction.Y / height;

        // Three octaves of noise, whose weights add up to 1.
        Vector256<float> thickness =
            (Large.At(x, y) * Vector256.Create(0.6f))
            + (Middle.At(x, y) * Vector256.Create(0.28f))
            + (Small.At(x, y) * Vector256.Create(0.12f));

        // Cloud where the noise exceeds a threshold that falls with the cover, with an edge a quarter wide, and none close to the horizon.
        Vector256<float> cover =
            Wide.Fraction((thickness + Vector256.Create((_clouds * 0.62f) - 0.72f)) * Vector256.Create(4f))
            * Wide.Fraction((height - Vector256.Create(MinCloudHeight)) * Vector256.Create(6f));
        WideVector cloud = WideVector.Of(_cloud) * (Vector256.Create(1.06f) - (Vector256.Create(0.3f) * thickness));
        return colour.Towards(cloud, cover * Vector256.Create(0.85f));
    }
}
