using System.Text;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Derivation;

/// <summary>
/// The finished frames of a session that is being derived from others, two lines each: that of the manifest and the label line. The first
/// line is the key of the work. Lines are appended when the files of their frames are on the disk, and a stopped command that is resumed
/// keeps the frames whose files are still as the lines say.
/// </summary>
internal sealed class SessionJournal : IDisposable
{
    /// <summary>Name of the file.</summary>
    public const string FileName = ".harvester-journal";

    private readonly string _path;
    private readonly bool _isDurable;
    private readonly List<string> _held = [];
    private FileStream? _file;

    private SessionJournal(string path, bool isDurable)
    {
        _path = path;
        _isDurable = isDurable;
    }

    /// <summary>Number of frames that an earlier run finished, and that are kept.</summary>
    public int Resumed { get; private set; }

    /// <summary>Opens the journal in a folder, and deletes what is in the folder besides the frames that are kept.</summary>
    /// <param name="folder">The folder, which is the caller's.</param>
    /// <param name="key">The key of the work: frames of other work are not kept.</param>
    /// <param name="resume">Whether to keep frames of an earlier run.</param>
    /// <param name="isDurable">Whether lines are on the disk once they are appended.</param>
    /// <exception cref="IOException">The journal cannot be read, or something not be deleted.</exception>
    public static SessionJournal Open(string folder, string key, bool resume, bool isDurable)
    {
        var journal = new SessionJournal(Path.Combine(folder, FileName), isDurable);
        if (!resume || !journal.TryResume(folder, key))
        {
            SessionFolder.Clear(folder);
            journal._held.Add(key);
        }

        return journal;
    }

    /// <summary>Takes a frame whose files are written; <see cref="Commit"/> writes its lines.</summary>
    public void Add(string manifestLine, string labelLine)
    {
        _held.Add(manifestLine);
        _held.Add(labelLine);
    }

    /// <summary>Writes the lines of the frames taken since the last call; their files must be on the disk.</summary>
    /// <exception cref="IOException">The disk refuses.</exception>
    public void Commit()
    {
        if (_held.Count < 2)
        {
            return;
        }

        bool isNew = _file is null;
        _file ??= AppendedFile.Open(_path);
        AppendedFile.AppendLines(_file, _held, _isDurable);
        _held.Clear();
        if (isNew && _isDurable)
        {
            var name = new SyncBatch();
            name.AddFolder(Path.GetDirectoryName(_path)!);
            name.Flush();
        }
    }

    /// <summary>The lines of all frames that are written.</summary>
    public IEnumerable<(string Manifest, string Label)> Read() =>
        File.Exists(_path) ? InputFile.ReadLines(_path).Skip(1).Chunk(2).Select(pair => (pair[0], pair[1])) : [];

    /// <inheritdoc />
    public void Dispose() => _file?.Dispose();

    private bool TryResume(string folder, string key)
    {
        if (!File.Exists(_path) || new FileInfo(_path).LinkTarget is not null)
        {
            return false;
        }

        long end = WholeLinesOf(folder, key);
        if (Resumed == 0)
        {
            return false;
        }

        SessionFolder.ClearAllButFrames(folder);
        _file = AppendedFile.Open(_path, FileAccess.ReadWrite);
        _file.SetLength(end);
        _file.Seek(end, SeekOrigin.Begin);
        return true;
    }

    /// <summary>Counts the frames that can be kept.</summary>
    /// <returns>Where the lines of the last of them end, bytes.</returns>
    private long WholeLinesOf(string folder, string key)
    {
        long size = new FileInfo(_path).Length;
        long end = Length(key);
        try
        {
            using IEnumerator<string> lines = InputFile.ReadLines(_path).GetEnumerator();
            if (!lines.MoveNext() || lines.Current != key)
            {
                return 0;
            }

            while (lines.MoveNext() && lines.Current is var manifest && lines.MoveNext() && lines.Current is var label)
            {
                long after = end + Length(manifest) + Length(label);
                if (after > size || !FinishedFrame.IsWhole(folder, manifest, label))
                {
                    break;
                }

                end = after;
                Resumed++;
            }
        }
        catch (DatasetFormatException)
        {
            // A damaged line ends what can be kept.
            return end;
        }

        return end;
    }

    private static long Length(string line) => Encoding.UTF8.GetByteCount(line) + 1;
}
