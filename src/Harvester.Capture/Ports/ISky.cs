namespace Harvester.Capture.Ports;

/// <summary>
/// Weather and time of day of a game that stands still. Setting them changes the light and nothing else. All calls come from the game's own
/// thread; exceptions pass through and end the harvest, which then calls <see cref="Restore"/>.
/// </summary>
public interface ISky
{
    /// <summary>Sets weather and time of day until the next call. The picture follows in one of the next ticks, or gradually.</summary>
    /// <param name="weather">One of the game's names, in lower case; null for the weather before the first call.</param>
    /// <param name="timeOfDay">At least 0 and less than 24 hours; null for the time of day before the first call.</param>
    /// <exception cref="ArgumentException">The game has no such weather.</exception>
    void Set(string? weather, TimeSpan? timeOfDay);

    /// <summary>Gives weather and time of day back as they were before the first call of <see cref="Set"/>. Calling it again has no
    /// effect.</summary>
    void Restore();
}
