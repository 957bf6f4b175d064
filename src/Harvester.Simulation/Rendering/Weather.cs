using System;
using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Rendering;

/// <summary>How the game's weathers and times of day look.</summary>
public static class Weather
{
    private static readonly Rgb Grey = new(150, 154, 160);

    /// <summary>Clouds, fog (fraction of the light lost per metre), rain and snow of each weather.</summary>
    private static readonly Dictionary<string, (double Clouds, double Fog, double Rain, double Snow)> Airs = new(StringComparer.Ordinal)
    {
        ["clear"] = (0.15, 0.0006, 0, 0),
        ["extrasunny"] = (0, 0.0003, 0, 0),
        ["clouds"] = (0.55, 0.0008, 0, 0),
        ["neutral"] = (0.35, 0.0011, 0, 0),
        ["overcast"] = (0.95, 0.0014, 0, 0),
        ["smog"] = (0.5, 0.008, 0, 0),
        ["foggy"] = (0.9, 0.022, 0, 0),
        ["clearing"] = (0.7, 0.002, 0.3, 0),
        ["rain"] = (1, 0.0045, 0.8, 0),
        ["thunder"] = (1, 0.006, 1, 0),
        ["snowlight"] = (0.8, 0.004, 0, 0.4),
        ["snow"] = (0.95, 0.007, 0, 0.8),
        ["xmas"] = (0.6, 0.003, 0, 0.7),
        ["blizzard"] = (1, 0.018, 0, 1),
        ["halloween"] = (0.9, 0.012, 0.15, 0),
    };

    /// <summary>The light of a weather at a time of day.</summary>
    /// <param name="weather">One of <see cref="WeatherNames.All"/>.</param>
    /// <param name="timeOfDay">Time since midnight.</param>
    /// <exception cref="ArgumentException">The game has no such weather.</exception>
    public static Lighting LightingOf(string weather, TimeSpan timeOfDay)
    {
        (double clouds, double fog, double rain, double snow) = Airs.TryGetValue(weather, out var air)
            ? air
            : throw new ArgumentException($"The weather is one of {string.Join(", ", WeatherNames.All)}, not '{weather}'.");

        // The sun rises at six in the east, stands highest at noon in the south, and sets at eighteen in the west.
        double hourAngle = (timeOfDay.TotalHours - 12) * Math.PI / 12;
        double height = (Math.Cos(hourAngle) * 0.8) + 0.12;
        double day = Math.Clamp((height + 0.05) / 0.35, 0, 1);
        double night = 1 - Math.Clamp((height + 0.12) / 0.24, 0, 1);
        double low = day * (1 - Math.Clamp(height / 0.5, 0, 1));
        double direct = 1 - (0.85 * clouds);
        Rgb horizon = new Rgb(188, 210, 230).Towards(new(244, 190, 140), low * 0.8 * direct).Towards(Grey, clouds * 0.75);
        Rgb zenith = new Rgb(66, 122, 196).Towards(new(96, 104, 150), low * 0.5).Towards(Grey.Scaled(0.9), clouds * 0.85);
        Rgb ambient = new Rgb(100, 110, 128).Towards(new(122, 124, 128), clouds);
        Rgb sun = new Rgb(170, 160, 142).Towards(new(190, 120, 66), low).Scaled(day * direct);
        Rgb moonlight = new Rgb(16, 20, 32).Scaled(direct);
        return new Lighting
        {
            SunDirection = new Vector3D(-Math.Sin(hourAngle), -0.35, night > 0.5 ? Math.Max(0.5, -height) : Math.Max(0.06, height))
                .Normalized(),
            SunColour = sun.Towards(moonlight, night),
            AmbientColour = ambient.Scaled(0.35 + (0.65 * day)).Towards(new(24, 28, 42), night),
            HorizonColour = horizon.Towards(new(30, 36, 54), night),
            ZenithColour = zenith.Towards(new(7, 10, 22), night),
            CloudFraction = clouds,
            FogDensity = fog,
            RainFraction = rain,
            SnowFraction = snow,
            NightFraction = night,
        };
    }
}
