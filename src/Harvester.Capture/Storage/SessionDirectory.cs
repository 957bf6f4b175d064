using System;
using System.IO;
using System.Text;
using Harvester.Sessions.Files;

namespace Harvester.Capture.Storage;

/// <summary>
/// A session's files in a directory. A frame's files are handed to the operating system before its label line is: after a crash of the
/// game every line has its files. (A loss of power may take what the system had not written yet.)
/// </summary>
internal sealed class SessionDirectory(string path) : ISessionFiles
{
    public const string Header = "session.json";
    public const string Labels = "labels.jsonl";

    private FileStream? _labels;

    public void MakeFolder(string name) => Directory.CreateDirectory(Path.Combine(path, name));

    public void WriteWhole(string name, Action<Stream> content) => AtomicFile.Write(Path.Combine(path, name), content);

    public void AppendLabel(string line)
    {
        _labels ??= new FileStream(Path.Combine(path, Labels), FileMode.Append, FileAccess.Write, FileShare.Read);
        long end = _labels.Length;
        byte[] bytes = new UTF8Encoding(false).GetBytes(line + "\n");
        try
        {
            _labels.Write(bytes, 0, bytes.Length);
            _labels.Flush();
        }
        catch
        {
            // Half a line, as a full disk leaves it, is taken back.
            _labels.SetLength(end);
            throw;
        }
    }

    public void Dispose() => _labels?.Dispose();
}
