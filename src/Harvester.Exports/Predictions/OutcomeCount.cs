namespace Harvester.Exports.Predictions;

/// <summary>Matches, misses and false positives of a group.</summary>
/// <param name="name">Name of the group.</param>
public sealed class OutcomeCount(string name)
{
    /// <summary>Name of the group.</summary>
    public string Name => name;

    /// <summary>Objects that a prediction matches.</summary>
    public int Matches { get; internal set; }

    /// <summary>Objects that no prediction matches.</summary>
    public int Misses { get; internal set; }

    /// <summary>Predictions that match no object.</summary>
    public int FalsePositives { get; internal set; }
}
