using System;
using System.IO;
using System.Text;

namespace Harvester.Capture.Storage;

/// <summary>
/// A session's files in a directory. A frame's files are handed to the operating system before its label line is: after a crash of the
/// game every line has its files. (A loss of power may take what the system had not written yet.)
/// </summary>
internal sealed class SessionDirectory(string path) : ISessionFiles
{
    public const string Header = "session.json";
    public const string Labels = "labels.jsonl";
    private const string Temporary = ".partial";

    private FileStream? _labels;

    public void MakeFolder(string name) => Directory.CreateDirectory(Path.Combine(path, name));

    public void WriteWhole(string name, Action<Stream> content)
    {
        string target = Path.Combine(path, name);
        string temporary = target + Temporary;
        try
        {
            using (var stream = new FileStream(temporary, FileMode.Create, FileAccess.Write, FileShare.None))
            {
                content(stream);
            }

            if (File.Exists(target))
            {
                File.Replace(temporary, target, null);
            }
            else
            {
                File.Move(temporary, target);
            }
        }
        catch
        {
            DeleteQuietly(temporary);
            throw;
        }
    }

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

    private static void DeleteQuietly(string file)
    {
        try
        {
            File.Delete(file);
        }
        catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
        {
            // The first failure is the one to tell; readers leave temporary names aside.
        }
    }
}
