using Harvester.Datasets.Files;
using Harvester.Sessions.Files;

namespace Harvester.Exports.Assembly;

/// <summary>Writes the manifest of a dataset: the files of each frame in the order of frames, then the others by their paths.</summary>
/// <param name="lines">Receives the lines.</param>
internal sealed class DatasetManifest(TextWriter lines)
{
    /// <summary>Number of files written so far.</summary>
    public int Files { get; private set; }

    /// <summary>Adds the files of a frame; parts of other files are left out.</summary>
    public void AddFrame(IEnumerable<KeyValuePair<string, FileDigest>> files)
    {
        foreach ((string path, FileDigest digest) in files)
        {
            if (!path.StartsWith(DatasetFolder.Working + "/", StringComparison.Ordinal))
            {
                Add(path, digest);
            }
        }
    }

    /// <summary>Adds files that belong to no single frame, once all frames were added.</summary>
    public void AddOthers(IEnumerable<KeyValuePair<string, FileDigest>> files)
    {
        foreach ((string path, FileDigest digest) in files.OrderBy(file => file.Key, StringComparer.Ordinal))
        {
            Add(path, digest);
        }
    }

    /// <summary>Adds a file.</summary>
    public void Add(string path, FileDigest digest)
    {
        lines.WriteLine(Manifest.FileLine(path, digest));
        Files++;
    }
}
