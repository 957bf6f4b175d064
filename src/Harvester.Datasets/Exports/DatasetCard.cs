using System;

namespace Harvester.Datasets.Exports;

/// <summary>What the dataset card on the Hugging Face hub says of a format.</summary>
/// <param name="Reader">Name of the hub's reader of the format.</param>
/// <param name="FilesOf">Pattern of the files of a split, relative to the folder of the dataset.</param>
internal sealed record DatasetCard(string Reader, Func<string, string> FilesOf);
