using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>Light, weather and fog at one moment. <see cref="Weather"/> makes it from the game's weather and time of day.</summary>
public sealed record Lighting
{
    /// <summary>Unit vector towards the sun, or at night towards the moon.</summary>
    public Vector3D SunDirection { get; init; } = new Vector3D(0.45, -0.35, 0.82).Normalized();

    /// <summary>Colour of a white surface perpendicular to the sun's rays, without the sky's contribution.</summary>
    public Rgb SunColour { get; init; } = new(165, 156, 140);

    /// <summary>Colour of a white surface in the shade.</summary>
    public Rgb AmbientColour { get; init; } = new(96, 106, 122);

    /// <summary>Colour of the sky overhead.</summary>
    public Rgb ZenithColour { get; init; } = new(74, 128, 196);

    /// <summary>Colour of the sky at the horizon, and of the fog.</summary>
    public Rgb HorizonColour { get; init; } = new(190, 212, 230);

    /// <summary>Colour of the glow at the horizon where the sun rises or sets; black for none.</summary>
    public Rgb GlowColour { get; init; }

    /// <summary>Level unit vector towards the middle of the glow.</summary>
    public Vector3D GlowDirection { get; init; } = new(0, 1, 0);

    /// <summary>Fog density per metre: a fraction exp(-density · distance) of the light comes through.</summary>
    public double FogDensity { get; init; } = 0.0006;

    /// <summary>Cloud cover, 0 to 1.</summary>
    public double CloudFraction { get; init; }

    /// <summary>Intensity of rain, 0 to 1.</summary>
    public double RainFraction { get; init; }

    /// <summary>Intensity of snowfall and cover of snow, 0 to 1.</summary>
    public double SnowFraction { get; init; }

    /// <summary>0 by day, 1 at night: lit windows and lamps brighten with it.</summary>
    public double NightFraction { get; init; }

    /// <summary>Seed of the positions of raindrops and snowflakes; different for each frame.</summary>
    public int PrecipitationSeed { get; init; }

    /// <summary>The light a fraction of the way to another one.</summary>
    internal Lighting Towards(Lighting other, double fraction)
    {
        double Mixed(double own, double others) => own + ((others - own) * fraction);
        return this with
        {
            SunDirection = (SunDirection + ((other.SunDirection - SunDirection) * fraction)).Normalized(),
            SunColour = SunColour.Towards(other.SunColour, fraction),
            AmbientColour = AmbientColour.Towards(other.AmbientColour, fraction),
            ZenithColour = ZenithColour.Towards(other.ZenithColour, fraction),
            HorizonColour = HorizonColour.Towards(other.HorizonColour, fraction),
            GlowColour = GlowColour.Towards(other.GlowColour, fraction),
            GlowDirection = (GlowDirection + ((other.GlowDirection - GlowDirection) * fraction)).Normalized(),
            FogDensity = Mixed(FogDensity, other.FogDensity),
            CloudFraction = Mixed(CloudFraction, other.CloudFraction),
            RainFraction = Mixed(RainFraction, other.RainFraction),
            SnowFraction = Mixed(SnowFraction, other.SnowFraction),
            NightFraction = Mixed(NightFraction, other.NightFraction),
        };
    }
}
