using Harvester.Capture.Storage;
using Harvester.Sessions.Files;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>
/// A session's directory that notes what is written and brought to the disk, in order, and whose disk may fail to keep files.
/// </summary>
internal sealed class OrderedFiles(string directory, int failingSync = int.MaxValue) : ISessionFiles
{
    private readonly SessionDirectory _files = new(directory);
    private int _syncs;

    /// <summary>Written files by their names, appended lines as "name +lines", and "sync".</summary>
    public List<string> Calls { get; } = [];

    public void MakeFolder(string name) => _files.MakeFolder(name);

    public FileDigest WriteWhole(string name, Action<Stream> content)
    {
        Calls.Add(name);
        return _files.WriteWhole(name, content);
    }

    public FileDigest DigestOf(string name) => _files.DigestOf(name);

    public void Append(string name, IReadOnlyList<string> lines, bool isDurable)
    {
        Calls.Add(FormattableString.Invariant($"{name} +{lines.Count}{(isDurable ? "" : " not durable")}"));
        _files.Append(name, lines, isDurable);
    }

    public void Sync()
    {
        Calls.Add("sync");
        if (++_syncs == failingSync)
        {
            throw new IOException("Input/output error");
        }

        _files.Sync();
    }

    public void TidyManifest(Predicate<int> isFrame, bool keepsReplaced, bool isDurable) =>
        _files.TidyManifest(isFrame, keepsReplaced, isDurable);

    public void Dispose() => _files.Dispose();
}
