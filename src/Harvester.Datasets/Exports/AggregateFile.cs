using System.Collections.Generic;

namespace Harvester.Datasets.Exports;

/// <summary>A file of a dataset that is put together from the parts of all frames.</summary>
/// <param name="Path">Its path within the dataset, with forward slashes.</param>
/// <param name="Sections">What it consists of, in order.</param>
public sealed record AggregateFile(string Path, IReadOnlyList<AggregateSection> Sections);
