using Harvester.Capture.Storage;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>A session's directory on a disk that does nothing until it is released.</summary>
internal sealed class SlowFiles(string directory) : ISessionFiles
{
    private readonly SessionDirectory _files = new(directory);
    private readonly ManualResetEventSlim _released = new();

    public void Release() => _released.Set();

    public void MakeFolder(string name) => _files.MakeFolder(name);

    public void WriteWhole(string name, Action<Stream> content)
    {
        _released.Wait();
        _files.WriteWhole(name, content);
    }

    public void AppendLabel(string line) => _files.AppendLabel(line);

    public void Dispose()
    {
        _files.Dispose();
        _released.Dispose();
    }
}
