using Harvester.Capture.Storage;

namespace Harvester.Capture.Tests.Doubles;

/// <summary>
/// A session's directory whose disk is full from a given write on, as the medium's own stream would tell: in the middle of a file.
/// </summary>
internal sealed class FailingFiles(string directory, int failingWrite) : ISessionFiles
{
    private readonly SessionDirectory _files = new(directory);
    private int _writes;

    public int Writes => _writes;

    public void MakeFolder(string name) => _files.MakeFolder(name);

    public void WriteWhole(string name, Action<Stream> content) =>
        _files.WriteWhole(name, stream =>
        {
            content(stream);
            FailIfDue();
        });

    public void AppendLabel(string line)
    {
        FailIfDue();
        _files.AppendLabel(line);
    }

    public void Dispose() => _files.Dispose();

    private void FailIfDue()
    {
        if (++_writes >= failingWrite)
        {
            throw new IOException("No space left on device.");
        }
    }
}
