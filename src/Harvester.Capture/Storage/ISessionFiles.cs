using Harvester.Sessions.Files;

namespace Harvester.Capture.Storage;

/// <summary>A session's files. A call that fails leaves files that were complete before unchanged.</summary>
internal interface ISessionFiles : IDisposable
{
    /// <summary>Creates a folder of the session unless it exists.</summary>
    void MakeFolder(string name);

    /// <summary>Writes a complete file: under a temporary name first, then renamed.</summary>
    FileDigest WriteWhole(string name, Action<Stream> content);

    /// <summary>The digest of a file of the session.</summary>
    FileDigest DigestOf(string name);

    /// <summary>Appends lines to a file, all of them or none; makes the file if it is missing.</summary>
    /// <param name="name">The file.</param>
    /// <param name="lines">The lines, without line feeds.</param>
    /// <param name="isDurable">Whether they are on the disk when this returns.</param>
    void Append(string name, IReadOnlyList<string> lines, bool isDurable);

    /// <summary>Writes to the disk the complete files since the last call, and the names in their folders.</summary>
    void Sync();

    /// <summary>Rewrites the manifest as <see cref="ManifestTidy"/> does.</summary>
    void TidyManifest(Predicate<int> isFrame, bool keepsReplaced, bool isDurable);
}
