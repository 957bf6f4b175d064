namespace Harvester.Sessions.Labels;

/// <summary>
/// A further picture of the moment of a frame: in another weather, at another hour, without some objects. The labels of the frame hold for
/// it, except for the objects that it does not show.
/// </summary>
/// <param name="File">Path of the picture within the session, with forward slashes; null if there is none.</param>
/// <param name="Weather">The game's name of the weather in lower case.</param>
/// <param name="TimeOfDay">Time since midnight in the game's world, less than a day.</param>
/// <param name="Without">Ids of the objects that are hidden, in ascending order; empty for all shown.</param>
public sealed record PairLabel(string? File, string Weather, TimeSpan TimeOfDay, IReadOnlyList<int> Without)
{
    /// <summary>Why there is no picture; null if there is one.</summary>
    public PairDrop? Dropped { get; init; }
}
