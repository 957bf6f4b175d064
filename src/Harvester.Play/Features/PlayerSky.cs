using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;

namespace Harvester.Play.Features;

/// <summary>
/// Weather and time of day of the game, set by its natives for pictures. What a restoring that failed has left is restored in a later
/// tick, or when the script ends.
/// </summary>
/// <param name="controls">Sets weather and time of day.</param>
/// <param name="world">Tells them.</param>
public sealed class PlayerSky(ICarControls controls, IWorld world) : ISky, IFeature
{
    private EnvironmentState? _before;
    private bool _isRestored = true;

    /// <summary>The weather to keep after a moment; null for that of the game.</summary>
    public Func<string?> Kept { get; init; } = static () => null;

    /// <inheritdoc/>
    public string Name => "Weather and time";

    /// <inheritdoc/>
    public bool IsOn => _before is not null;

    /// <inheritdoc/>
    public void Set(string? weather, TimeSpan? timeOfDay)
    {
        if (weather is not null && !WeatherNames.IsKnown(weather))
        {
            throw new ArgumentException($"The game has no weather '{weather}'.", nameof(weather));
        }

        _isRestored = false;
        _before ??= world.ReadEnvironment();
        Show(weather ?? _before.Weather, timeOfDay ?? _before.TimeOfDay);
    }

    /// <inheritdoc/>
    public void Restore()
    {
        _isRestored = true;
        GiveBack();
    }

    /// <inheritdoc/>
    public void Tick()
    {
        if (_isRestored)
        {
            GiveBack();
        }
    }

    /// <inheritdoc/>
    public void Stop() => Restore();

    private void GiveBack()
    {
        if (_before is { } before)
        {
            Show(before.Weather, before.TimeOfDay);
            controls.KeepWeather(Kept());
            _before = null;
        }
    }

    private void Show(string weather, TimeSpan timeOfDay)
    {
        // The game may be between two weathers that scripts cannot name.
        if (WeatherNames.IsKnown(weather))
        {
            controls.KeepWeather(weather);
        }

        controls.SetTimeOfDay(timeOfDay);
    }
}
