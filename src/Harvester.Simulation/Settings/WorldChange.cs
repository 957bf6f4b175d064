namespace Harvester.Simulation.Settings;

/// <summary>A single intervention in the simulated world; everything else goes on by the same rules and the same chance.</summary>
/// <param name="Kind">What is done.</param>
/// <param name="Handle">The entity that is meant; 0 for the ego, and for the weather.</param>
public sealed record WorldChange(WorldChangeKind Kind, int Handle = 0)
{
    /// <summary>
    /// For <see cref="WorldChangeKind.Brake"/> the deceleration, m/s²; for <see cref="WorldChangeKind.Drive"/> the speed, m/s.
    /// </summary>
    public double Value { get; init; }

    /// <summary>For <see cref="WorldChangeKind.Brake"/>: how long the driver brakes and stands, seconds; null for ever.</summary>
    public double? Seconds { get; init; }

    /// <summary>For <see cref="WorldChangeKind.Weather"/>: one of <see cref="Sessions.Scenes.WeatherNames.All"/>.</summary>
    public string? Weather { get; init; }
}
