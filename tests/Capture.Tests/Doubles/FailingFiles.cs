using Harvester.Capture.Storage;
using Harvester.Sessions.Files;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>
/// A session's directory whose disk is full from a given write on, permanently or for some writes, in the middle of a file, as a real
/// stream reports it.
/// </summary>
internal sealed class FailingFiles(string directory, int failingWrite, int failures = int.MaxValue) : ISessionFiles
{
    private readonly SessionDirectory _files = new(directory);
    private int _writes;

    public int Writes => _writes;

    public void MakeFolder(string name) => _files.MakeFolder(name);

    public FileDigest WriteWhole(string name, Action<Stream> content) =>
        _files.WriteWhole(
            name,
            stream =>
            {
                content(stream);
                FailIfDue();
            }
        );

    public FileDigest DigestOf(string name) => _files.DigestOf(name);

    public void Append(string name, IReadOnlyList<string> lines, bool isDurable)
    {
        FailIfDue();
        _files.Append(name, lines, isDurable);
    }

    public void Sync()
    {
        FailIfDue();
        _files.Sync();
    }

    public void TidyManifest(Predicate<int> isFrame, bool keepsReplaced, bool isDurable)
    {
        FailIfDue();
        _files.TidyManifest(isFrame, keepsReplaced, isDurable);
    }

    public void Dispose() => _files.Dispose();

    private void FailIfDue()
    {
        if (++_writes >= failingWrite && _writes - failingWrite < failures)
        {
            throw new IOException("No space left on device.");
        }
    }
}
