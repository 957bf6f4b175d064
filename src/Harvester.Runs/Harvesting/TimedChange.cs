using Harvester.Simulation.Settings;

namespace Harvester.Runs.Harvesting;

/// <summary>A change of the world at a moment of a harvest: of the frame, the game time and the event, one is given.</summary>
/// <param name="Text">The change as it was written.</param>
/// <param name="Change">What is changed; the handle is that of the entity whose number the text names.</param>
public sealed record TimedChange(string Text, WorldChange Change)
{
    /// <summary>The change takes effect right after this frame, from 0; null if another moment is given.</summary>
    public int? Frame { get; init; }

    /// <summary>The change takes effect in the first tick at or after this game time, seconds; null if another moment is given.</summary>
    public double? Seconds { get; init; }

    /// <summary>The change takes effect when this event of the scenario begins in the base; null if another moment is given.</summary>
    public string? Event { get; init; }

    /// <summary>The game frame in which <see cref="Event"/> begins; null until that is known.</summary>
    public long? GameFrame { get; init; }

    /// <summary>The number in labels of the object that is meant; null for the ego, the weather and actors.</summary>
    public int? Id { get; init; }

    /// <summary>The actor of the scenario that is meant; null for others.</summary>
    public string? Actor { get; init; }
}
