using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Harvester.Datasets.Files;
using Harvester.Datasets.Images;

namespace Harvester.Datasets.Exports;

/// <summary>An exported dataset as its check sees it. Names are paths within it, with forward slashes.</summary>
/// <param name="folder">Its folder.</param>
/// <param name="options">What it was exported with.</param>
internal sealed class DatasetContent(string folder, ExportOptions options)
{
    private readonly Dictionary<string, int> _frames = new(StringComparer.Ordinal);

    /// <summary>What it was exported with: splits and classes.</summary>
    public ExportOptions Options => options;

    /// <summary>Names of its splits.</summary>
    public IEnumerable<string> Splits => options.Splits.Splits.Select(split => split.Name);

    /// <summary>How many frames the check found in each split.</summary>
    public IReadOnlyDictionary<string, int> FramesOfSplits => _frames;

    /// <summary>The check found frames of a split.</summary>
    public void Found(string split, int frames = 1) => _frames[split] = _frames.GetValueOrDefault(split) + frames;

    /// <exception cref="DatasetFormatException">The name leads out of the dataset, or to a pipe or a device.</exception>
    public string PathOf(string name) => InnerPath.Of(folder, name);

    public bool Has(string name) => InnerPath.IsWithin(folder, name) && File.Exists(PathOf(name));

    /// <summary>Names of the files right in a folder, in ordinal order; none when there is no such folder.</summary>
    public IReadOnlyList<string> Files(string within) => Sorted(within, Directory.EnumerateFiles);

    /// <summary>Names of the folders right in a folder, in ordinal order; none when there is no such folder.</summary>
    public IReadOnlyList<string> Folders(string within) => Sorted(within, Directory.EnumerateDirectories);

    /// <summary>The header of an image; null when it is missing or damaged, which is said elsewhere.</summary>
    public ImageHeader? Header(string name)
    {
        try
        {
            return Has(name) ? ImageHeader.Read(PathOf(name)) : null;
        }
        catch (DatasetFormatException)
        {
            return null;
        }
    }

    /// <summary>The lines of a text file with their numbers from 1; none when it is missing.</summary>
    public IEnumerable<(int Number, string Text)> Lines(string name) =>
        Has(name) ? InputFile.ReadLines(PathOf(name)).Select((text, index) => (index + 1, text)) : [];

    private IReadOnlyList<string> Sorted(string within, Func<string, IEnumerable<string>> list)
    {
        string path = PathOf(within);
        return Directory.Exists(path)
            ? [.. list(path).Select(entry => $"{within}/{Path.GetFileName(entry)}").Order(StringComparer.Ordinal)] : [];
    }
}
