namespace Harvester.Exports.Pairs;

/// <summary>A run of a set of counterfactuals in which something was changed.</summary>
/// <param name="Folder">Folder of its session, beside the base.</param>
/// <param name="Change">What was changed and when, as on the command line.</param>
public sealed record ChangedRun(string Folder, string Change);
