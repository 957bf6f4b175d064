namespace Harvester.Exports;

/// <summary>A file of a dataset that is assembled from parts of all frames.</summary>
/// <param name="Path">Path within the dataset, with forward slashes.</param>
/// <param name="Sections">The sections of the file, in order.</param>
public sealed record AggregateFile(string Path, IReadOnlyList<AggregateSection> Sections);
