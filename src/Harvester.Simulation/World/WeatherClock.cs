using Harvester.Sessions.Scenes;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.World;

/// <summary>The weather and time of day of a game; the latter advances with the world's time.</summary>
internal sealed class WeatherClock
{
    private const double RealSecondsPerGameMinute = 2;
    private const int FirstDay = 1;
    private readonly bool _isTimeFixed;
    private readonly int _dayOfYear;
    private string _weather;
    private TimeSpan _start;

    /// <summary>Starts at the weather and time of day of the options.</summary>
    /// <exception cref="ArgumentException">The game has no such weather.</exception>
    public WeatherClock(SimulationOptions options)
    {
        _isTimeFixed = options.IsTimeOfDayFixed;
        _dayOfYear = options.DayOfYear;
        (_weather, _start) = Checked(options.Weather, options.TimeOfDay);
    }

    /// <summary>The weather and time of day at a time of the world, seconds.</summary>
    public EnvironmentState At(double worldSeconds) => new(_weather, TimeOfDay(worldSeconds));

    /// <summary>The light at a time of the world, seconds.</summary>
    public Lighting LightingAt(double worldSeconds) => Weather.LightingOf(_weather, _dayOfYear, TimeOfDay(worldSeconds));

    /// <summary>Whether it is so dark, by the hour or by rain, that drivers have their headlights on.</summary>
    public bool IsDarkAt(double worldSeconds)
    {
        const double dusk = 0.25;
        const double heavyRain = 0.5;
        Lighting lighting = LightingAt(worldSeconds);
        return lighting.NightFraction > dusk || lighting.RainFraction > heavyRain;
    }

    /// <summary>Sets weather, time of day or both; null leaves a value unchanged.</summary>
    /// <exception cref="ArgumentException">The game has no such weather; nothing is set.</exception>
    public void Set(string? weather, TimeSpan? timeOfDay, double worldSeconds) =>
        (_weather, _start) = Checked(weather ?? _weather, timeOfDay is { } now ? _start + now - TimeOfDay(worldSeconds) : _start);

    /// <summary>What was set, to be given back to <see cref="Restore"/>.</summary>
    public (string Weather, TimeSpan Start) Keep() => (_weather, _start);

    /// <summary>Sets what was kept.</summary>
    public void Restore((string Weather, TimeSpan Start) kept) => (_weather, _start) = kept;

    private static (string Weather, TimeSpan Start) Checked(string weather, TimeSpan start)
    {
        _ = Weather.LightingOf(weather, FirstDay, start);
        return (weather, start);
    }

    private TimeSpan TimeOfDay(double worldSeconds)
    {
        double gameMinutes = _isTimeFixed ? 0 : worldSeconds / RealSecondsPerGameMinute;
        long ticks = (_start + TimeSpan.FromMinutes(gameMinutes)).Ticks % TimeSpan.TicksPerDay;
        return TimeSpan.FromTicks(ticks < 0 ? ticks + TimeSpan.TicksPerDay : ticks);
    }
}
