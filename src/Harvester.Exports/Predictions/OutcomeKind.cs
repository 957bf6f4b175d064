namespace Harvester.Exports.Predictions;

/// <summary>What became of a prediction.</summary>
internal enum OutcomeKind
{
    /// <summary>It matches an object.</summary>
    Matched,

    /// <summary>It matches nothing: a false positive.</summary>
    False,

    /// <summary>It lies in an ignore region and does not count.</summary>
    Ignored,
}
