using Harvester.Capture.Storage;
using Harvester.Sessions.Files;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>A session's directory on a disk that does nothing until it is released.</summary>
internal sealed class SlowFiles(string directory) : ISessionFiles
{
    private readonly SessionDirectory _files = new(directory);
    private readonly ManualResetEventSlim _released = new();

    public void Release() => _released.Set();

    public void MakeFolder(string name) => _files.MakeFolder(name);

    public FileDigest WriteWhole(string name, Action<Stream> content)
    {
        _released.Wait();
        return _files.WriteWhole(name, content);
    }

    public FileDigest DigestOf(string name) => _files.DigestOf(name);

    public void Append(string name, IReadOnlyList<string> lines, bool isDurable) => _files.Append(name, lines, isDurable);

    public void Sync() => _files.Sync();

    public void TidyManifest(Predicate<int> isFrame, bool keepsReplaced, bool isDurable) =>
        _files.TidyManifest(isFrame, keepsReplaced, isDurable);

    public void Dispose()
    {
        _files.Dispose();
        _released.Dispose();
    }
}
