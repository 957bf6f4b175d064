using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Validation;

/// <summary>Compares files with what the manifest says of them.</summary>
internal static class DigestCheck
{
    /// <summary>Compares a frame's file.</summary>
    /// <param name="path">Where the file is.</param>
    /// <param name="name">Its path in the session.</param>
    /// <param name="frame">The entry of its frame; null for a session without a manifest.</param>
    /// <returns>What is wrong, to follow the name; null for nothing.</returns>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static string? Problem(string path, string name, ManifestFrame? frame) =>
        frame is null ? null
        : !frame.Files.TryGetValue(name, out FileDigest digest) ? $"is not listed in {Manifest.FileName}."
        : Problem(path, [digest]);

    /// <summary>Compares a file.</summary>
    /// <param name="path">Where the file is.</param>
    /// <param name="digests">What it may be.</param>
    /// <returns>What is wrong, to follow the name; null for nothing.</returns>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static string? Problem(string path, IReadOnlyList<FileDigest> digests)
    {
        using FileStream file = InputFile.OpenRead(path);
        long bytes = file.Length;
        return digests.All(digest => digest.Bytes != bytes)
                ? $"has {bytes} bytes instead of the {digests[^1].Bytes} in {Manifest.FileName}."
            : !digests.Contains(FileDigest.OfFile(path)) ? $"is damaged: its SHA-256 differs from {Manifest.FileName}."
            : null;
    }
}
