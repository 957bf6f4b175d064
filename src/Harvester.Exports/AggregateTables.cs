namespace Harvester.Exports;

/// <summary>Files of a dataset that all follow from the parts of one name, and are written side by side in one pass over them.</summary>
/// <param name="Part">Name of the parts.</param>
/// <param name="Paths">Paths within the dataset, with forward slashes.</param>
/// <param name="Write">
/// Writes the files, in the order of their paths; it gets the parts in the order of the frames, so that it can hold one at a time.
/// </param>
public sealed record AggregateTables(
    string Part,
    IReadOnlyList<string> Paths,
    Action<IReadOnlyList<TextWriter>, IEnumerable<string>> Write
);
