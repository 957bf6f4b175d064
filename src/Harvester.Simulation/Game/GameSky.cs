using Harvester.Sessions.Scenes;
using Harvester.Simulation.Quirks;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Game;

/// <summary>Weather, time of day and the light of both. All times are those of the world, seconds.</summary>
internal sealed class GameSky(SimulationOptions options)
{
    private readonly WeatherClock _weather = new(options);
    private readonly SkyFade _fade = new(options.Quirks.SlowSkyTicks);
    private (string Weather, TimeSpan Start)? _before;

    /// <summary>By how much the sky is ahead of the world, which may be frozen while it goes on, seconds.</summary>
    private double _aheadSeconds;

    /// <summary>Counts the states of what falls.</summary>
    private int _precipitation;

    /// <summary>Weather and time of day.</summary>
    public EnvironmentState EnvironmentAt(double seconds) => _weather.At(seconds + _aheadSeconds);

    /// <summary>Whether it is dark.</summary>
    public bool IsDarkAt(double seconds) => _weather.IsDarkAt(seconds + _aheadSeconds);

    /// <summary>How strong the rain is, 0 to 1.</summary>
    public double RainAt(double seconds) => _weather.LightingAt(seconds + _aheadSeconds).RainFraction;

    /// <summary>The light that the pictures show, which a game may change slowly.</summary>
    public Lighting LightAt(double seconds) =>
        _fade.Shown(_weather.LightingAt(seconds + _aheadSeconds)) with
        {
            PrecipitationSeed = _precipitation,
        };

    /// <summary>What falls has moved.</summary>
    public void Fall() => _precipitation++;

    /// <summary>The sky goes on by a time without the world, seconds; less than 0 if the world alone has gone on.</summary>
    public void GoOn(double seconds) => _aheadSeconds += seconds;

    /// <summary>Ends a tick.</summary>
    /// <returns>Whether the light has changed.</returns>
    public bool Tick() => _fade.Tick();

    /// <summary>Sets weather, time of day or both; null leaves a value unchanged.</summary>
    public void Set(string? weather, TimeSpan? timeOfDay, double seconds) => _weather.Set(weather, timeOfDay, seconds + _aheadSeconds);

    /// <summary>Sets weather and time of day until <see cref="Restore"/>; null for those before.</summary>
    public void Replace(string? weather, TimeSpan? timeOfDay, double seconds)
    {
        Lighting shown = LightAt(seconds);
        _before ??= _weather.Keep();
        _weather.Restore(_before.Value);
        Set(weather, timeOfDay, seconds);
        _fade.Begin(shown);
    }

    /// <summary>Gives back what was replaced.</summary>
    /// <returns>Whether anything was.</returns>
    public bool Restore(double seconds)
    {
        if (_before is not { } before)
        {
            return false;
        }

        _fade.Begin(LightAt(seconds));
        _before = null;
        _weather.Restore(before);
        return true;
    }
}
