using Harvester.Sessions.Files;

namespace Harvester.Capture.Storage;

/// <summary>A session's files in a directory.</summary>
internal sealed class SessionDirectory(string path) : ISessionFiles
{
    public const string Header = "session.json";
    public const string Labels = "labels.jsonl";

    private readonly Dictionary<string, FileStream> _appended = new(StringComparer.Ordinal);
    private readonly SyncBatch _written = new();
    private bool _isNamed;

    public void MakeFolder(string name)
    {
        string folder = Path.Combine(path, name);
        if (!Directory.Exists(folder))
        {
            Directory.CreateDirectory(folder);
            _written.AddFolder(Path.GetDirectoryName(folder)!);
        }
    }

    public FileDigest WriteWhole(string name, Action<Stream> content)
    {
        FileDigest digest = default;
        string file = Path.Combine(path, name);
        AtomicFile.Write(file, stream => digest = DigestStream.Write(stream, content), isDurable: false);
        _written.Add(file);
        return digest;
    }

    public FileDigest DigestOf(string name) => FileDigest.OfFile(Path.Combine(path, name));

    public void Append(string name, IReadOnlyList<string> lines, bool isDurable)
    {
        if (!_appended.TryGetValue(name, out FileStream? file))
        {
            file = AppendedFile.Open(Path.Combine(path, name));
            _appended.Add(name, file);
            if (isDurable)
            {
                DiskSync.Folder(path);
            }
        }

        if (lines.Count == 0)
        {
            return;
        }

        AppendedFile.AppendLines(file, lines, isDurable);
    }

    public void Sync()
    {
        if (!_isNamed)
        {
            // The folder itself may be new.
            _written.AddFolder(Path.GetDirectoryName(Path.GetFullPath(path))!);
            _isNamed = true;
        }

        _written.Flush();
    }

    public void TidyManifest(Predicate<int> isFrame, bool keepsReplaced, bool isDurable)
    {
        // On Windows a file cannot be replaced while it is open.
        if (_appended.TryGetValue(Manifest.FileName, out FileStream? file))
        {
            file.Dispose();
            _appended.Remove(Manifest.FileName);
        }

        ManifestTidy.Run(path, isFrame, keepsReplaced, isDurable);
    }

    public void Dispose()
    {
        foreach (FileStream file in _appended.Values)
        {
            file.Dispose();
        }
    }
}
