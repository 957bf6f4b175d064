using Harvester.Simulation.Settings;

namespace Harvester.Runs.Harvesting;

/// <summary>A change of the world at a moment of a harvest.</summary>
/// <param name="Text">The change as it was written.</param>
/// <param name="Change">What is changed; the handle is that of the entity whose number the text names.</param>
public sealed record TimedChange(string Text, WorldChange Change)
{
    /// <summary>The change takes effect right after this frame, from 0; null if the time is given.</summary>
    public int? Frame { get; init; }

    /// <summary>The change takes effect in the first tick at or after this game time, seconds; null if the frame is given.</summary>
    public double? Seconds { get; init; }

    /// <summary>The number in labels of the object that is meant; null for the ego and the weather.</summary>
    public int? Id { get; init; }
}
