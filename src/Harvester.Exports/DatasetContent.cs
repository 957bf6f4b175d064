using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports;

/// <summary>An exported dataset, as read by its check. Names are paths within it, with forward slashes.</summary>
/// <param name="folder">Folder of the dataset.</param>
/// <param name="options">The options of the export.</param>
internal sealed class DatasetContent(string folder, ExportOptions options)
{
    private readonly Dictionary<string, int> _frames = new(StringComparer.Ordinal);

    /// <summary>The options of the export, including splits and classes.</summary>
    public ExportOptions Options => options;

    /// <summary>Names of the splits.</summary>
    public IEnumerable<string> Splits => options.Splits.Splits.Select(split => split.Name);

    /// <summary>Number of frames that the check found in each split.</summary>
    public IReadOnlyDictionary<string, int> FramesOfSplits => _frames;

    /// <summary>Counts frames of a split.</summary>
    public void Found(string split, int frames = 1) => _frames[split] = _frames.GetValueOrDefault(split) + frames;

    /// <exception cref="DatasetFormatException">The name points outside the dataset, or to a pipe or device.</exception>
    public string PathOf(string name) => InnerPath.Of(folder, name);

    public bool Has(string name) => InnerPath.IsWithin(folder, name) && File.Exists(PathOf(name));

    /// <summary>Names of the files in a folder, without subfolders, in ordinal order; empty if there is no such folder.</summary>
    public IReadOnlyList<string> Files(string within) => Sorted(within, Directory.EnumerateFiles);

    /// <summary>Names of the folders in a folder, in ordinal order; empty if there is no such folder.</summary>
    public IReadOnlyList<string> Folders(string within) => Sorted(within, Directory.EnumerateDirectories);

    /// <summary>The header of an image; null if it is missing or damaged, which is reported elsewhere.</summary>
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

    /// <summary>The lines of a text file with their numbers from 1; empty if it is missing.</summary>
    public IEnumerable<(int Number, string Text)> Lines(string name) =>
        Has(name) ? InputFile.ReadLines(PathOf(name)).Select((text, index) => (index + 1, text)) : [];

    private IReadOnlyList<string> Sorted(string within, Func<string, IEnumerable<string>> list)
    {
        string path = PathOf(within);
        return Directory.Exists(path)
            ? [.. list(path).Select(entry => $"{within}/{Path.GetFileName(entry)}").Order(StringComparer.Ordinal)]
            : [];
    }
}
