using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>The light and air of a moment. <see cref="Weather"/> makes one from the game's weather and hour.</summary>
public sealed record Lighting
{
    /// <summary>Unit vector towards the sun, or towards the moon by night.</summary>
    public Vector3D SunDirection { get; init; } = new Vector3D(0.45, -0.35, 0.82).Normalized();

    /// <summary>Colour of a white surface square to the sun, without the sky's share.</summary>
    public Rgb SunColour { get; init; } = new(165, 156, 140);

    /// <summary>Colour of a white surface in shade.</summary>
    public Rgb AmbientColour { get; init; } = new(96, 106, 122);

    /// <summary>The sky overhead.</summary>
    public Rgb ZenithColour { get; init; } = new(74, 128, 196);

    /// <summary>The sky at the horizon, and the colour of the fog.</summary>
    public Rgb HorizonColour { get; init; } = new(190, 212, 230);

    /// <summary>How much of the view is lost to fog each metre: a share exp(-density · distance) comes through.</summary>
    public double FogDensity { get; init; } = 0.0006;

    /// <summary>Clouds over the sky, 0 to 1.</summary>
    public double CloudFraction { get; init; }

    /// <summary>Rain falling, 0 to 1.</summary>
    public double RainFraction { get; init; }

    /// <summary>Snow falling and lying, 0 to 1.</summary>
    public double SnowFraction { get; init; }

    /// <summary>0 by day, 1 by night: lit windows and lamps come on with it.</summary>
    public double NightFraction { get; init; }

    /// <summary>Chooses where raindrops and snowflakes are; give each frame its own.</summary>
    public int PrecipitationSeed { get; init; }
}
