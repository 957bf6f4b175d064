using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Datasets.Derivation;

/// <summary>
/// Digests of a session's files, for a session derived from it. They come from its manifest where it lists the file, so that later damage
/// can still be detected, and are computed from the file otherwise.
/// </summary>
internal sealed class CarriedDigests(SessionReader session) : IDisposable
{
    private readonly ManifestReader? _manifest = ManifestReader.Open(session);
    private ManifestFrame? _frame;
    private int _number = -1;

    /// <summary>The digest of a frame's file. Frames are asked for by rising numbers.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public FileDigest Of(int frame, string name)
    {
        if (_number != frame)
        {
            _frame = _manifest?.Frame(frame);
            _number = frame;
        }

        return _frame is not null && _frame.Files.TryGetValue(name, out FileDigest known) ? known : AsIs(name);
    }

    /// <summary>The digest of a file that belongs to no single frame; after this, frames are not asked for any more.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public FileDigest Of(string name)
    {
        _manifest?.ReadToEnd();
        return _manifest is not null && _manifest.Files.TryGetValue(name, out List<FileDigest>? known) ? known[^1] : AsIs(name);
    }

    /// <inheritdoc />
    public void Dispose() => _manifest?.Dispose();

    private FileDigest AsIs(string name) => FileDigest.OfFile(session.PathOf(name));
}
