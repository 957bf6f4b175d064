using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Rendering;

/// <summary>How the game's weathers and times of day look.</summary>
public static class Weather
{
    /// <summary>So far below the horizon the sun leaves no light: the sine of 10 degrees.</summary>
    private const double NightHeight = 0.18;

    /// <summary>Shadows of a lower sun would have no end.</summary>
    private const double MinSunHeight = 0.04;

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

    /// <summary>The light of a weather at a time of the year and day.</summary>
    /// <param name="weather">One of <see cref="WeatherNames.All"/>.</param>
    /// <param name="dayOfYear">1 to 366.</param>
    /// <param name="timeOfDay">Time since midnight.</param>
    /// <exception cref="ArgumentException">The game has no such weather.</exception>
    public static Lighting LightingOf(string weather, int dayOfYear, TimeSpan timeOfDay)
    {
        (double clouds, double fog, double rain, double snow) = Airs.TryGetValue(weather, out var air)
            ? air
            : throw new ArgumentException($"The weather is one of {string.Join(", ", WeatherNames.All)}, not '{weather}'.");

        Vector3D towardsSun = SunPosition.DirectionAt(dayOfYear, timeOfDay);
        double height = towardsSun.Z;

        // All by the sine of the sun's height: full day from 14° above the horizon, none 6° below it; lamps and stars from 4° above to 10°
        // below; the sky dark from 3° above to 12° below.
        double day = Math.Clamp((height + 0.1) / 0.35, 0, 1);
        double dark = 1 - Math.Clamp((height + NightHeight + 0.02) / 0.25, 0, 1);
        double night = 1 - Math.Clamp((height + NightHeight) / 0.25, 0, 1);

        // Warm light of a low sun: most at the horizon, none from 24° on.
        double low = day * (1 - Math.Clamp(height / 0.4, 0, 1));
        double direct = 1 - (0.85 * clouds);

        // Colours of dusk: most just below the horizon, over 9° to either side. Clouds take most of the direct light.
        double dusk = Math.Max(0, 1 - (Math.Abs(height + 0.02) / 0.16)) * direct;
        Rgb horizon = new Rgb(188, 210, 230)
            .Towards(new(206, 176, 160), low * 0.8 * direct)
            .Towards(Grey, clouds * 0.75)
            .Towards(new(214, 150, 128), 0.6 * dusk);
        Rgb zenith = new Rgb(66, 122, 196)
            .Towards(new(74, 92, 150), low * 0.6)
            .Towards(new(52, 66, 122), 0.7 * dusk)
            .Towards(Grey.Scaled(0.9), clouds * 0.85);
        Rgb ambient = new Rgb(100, 110, 128).Towards(new(122, 124, 128), clouds).Towards(new(172, 175, 182), 0.6 * snow);
        Rgb sun = new Rgb(170, 160, 142).Towards(new(190, 112, 56), low).Scaled(Math.Clamp((height + 0.02) / 0.12, 0, 1) * direct);
        Rgb moonlight = new Rgb(26, 32, 48).Scaled(direct * night);
        double glow = Math.Max(0, 1 - (Math.Abs(height) / 0.22)) * direct;
        return new Lighting
        {
            // The moon stands high in the south; before it shines, the sun's last light comes from the horizon.
            SunDirection = (
                night > 0.5
                    ? new Vector3D(-towardsSun.X, -0.35, Math.Max(0.5, -height))
                    : towardsSun with
                    {
                        Z = Math.Max(MinSunHeight, height),
                    }
            ).Normalized(),
            SunColour = sun.Towards(moonlight, night),
            AmbientColour = ambient.Scaled(0.35 + (0.65 * day)).Towards(new(34, 38, 54), night),
            HorizonColour = horizon.Towards(new(30, 36, 54), dark),
            ZenithColour = zenith.Towards(new(7, 10, 22), dark),
            GlowColour = new Rgb(255, 146, 74).Scaled(glow),
            GlowDirection = (towardsSun with { Z = 0 }).Normalized(),
            CloudFraction = clouds,
            FogDensity = fog,
            RainFraction = rain,
            SnowFraction = snow,
            NightFraction = night,
        };
    }
}
