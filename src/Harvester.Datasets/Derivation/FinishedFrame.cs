using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Derivation;

/// <summary>Whether a frame that a stopped command finished is still as it was written.</summary>
internal static class FinishedFrame
{
    /// <summary>Whether a label line and the files of its frame are those of the manifest.</summary>
    /// <param name="folder">The session.</param>
    /// <param name="manifestLine">The line of the manifest.</param>
    /// <param name="labelLine">The label line.</param>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public static bool IsWhole(string folder, string manifestLine, string labelLine)
    {
        try
        {
            ManifestFrame frame = ManifestParser.Frame(manifestLine);
            return frame.Label == FileDigest.Of(labelLine) && AreWhole(folder, frame.Files);
        }
        catch (DatasetFormatException)
        {
            return false;
        }
    }

    /// <summary>Whether files have the size and the checksum that they should have.</summary>
    /// <param name="folder">Their folder.</param>
    /// <param name="files">Their paths within it, with digests.</param>
    /// <exception cref="DatasetFormatException">A path leads out of the folder.</exception>
    /// <exception cref="IOException">A file cannot be read.</exception>
    public static bool AreWhole(string folder, IEnumerable<KeyValuePair<string, FileDigest>> files) =>
        files.All(file => IsWhole(InnerPath.Of(folder, file.Key), file.Value));

    /// <summary>Whether a file has the size and the checksum that it should have.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static bool IsWhole(string path, FileDigest digest) =>
        new FileInfo(path) is { Exists: true } file && file.Length == digest.Bytes && FileDigest.OfFile(path) == digest;
}
