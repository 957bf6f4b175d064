using Harvester.Sessions.Files;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Sessions.Reading;

/// <summary>
/// Reads the manifest of a session beside its labels. Both have the frames in the same order, so that neither is held whole; where either
/// is damaged, lines are matched by the checksums of label lines.
/// </summary>
public sealed class ManifestReader : IDisposable
{
    // A session has three such files; while it is recorded, each may have been replaced several times.
    private const int MaxFiles = 1000;

    // How many frames may be missing between two that match.
    private const int MaxAhead = 4096;

    private readonly IEnumerator<string> _lines;
    private readonly List<ManifestFrame> _ahead = [];
    private readonly Dictionary<string, List<FileDigest>> _files = new(StringComparer.Ordinal);
    private readonly ProblemList _problems = new();
    private int _number;
    private int _count;

    private ManifestReader(string path)
    {
        IsUnfinished = LineEnd.IsMissing(path);
        _lines = InputFile.ReadLines(path).GetEnumerator();
    }

    /// <summary>Whether the last line has no line feed, because writing it was cut off.</summary>
    public bool IsUnfinished { get; }

    /// <summary>Damaged lines among those read so far. If the list is full, the rest of the manifest is not read.</summary>
    public IReadOnlyList<SessionProblem> Problems => _problems;

    /// <summary>Frames read so far that were skipped because no label line matched them.</summary>
    public int Passed { get; private set; }

    /// <summary>
    /// Files that belong to no single frame, among those read so far, with the digests that they may have: more than one while a file is
    /// replaced.
    /// </summary>
    public IReadOnlyDictionary<string, List<FileDigest>> Files => _files;

    /// <summary>Opens the manifest of a session; null for a session of an earlier version, which has none.</summary>
    /// <exception cref="IOException">It cannot be read.</exception>
    public static ManifestReader? Open(SessionReader session)
    {
        string path = session.PathOf(Manifest.FileName);
        return File.Exists(path) ? new ManifestReader(path) : null;
    }

    /// <summary>What it says of a frame; null for nothing.</summary>
    /// <param name="number">Number of the frame, greater than those asked for before.</param>
    public ManifestFrame? Frame(int number)
    {
        while (At(0) is { } passed && passed.Frame < number)
        {
            Passed++;
            _ahead.RemoveAt(0);
        }

        return At(0) is { } frame && frame.Frame == number ? Take(0) : null;
    }

    /// <summary>
    /// The entry of a label line's frame. It is found by the checksum of the line or, if either file is damaged, by the number of the
    /// frame; in the second case it can be found again.
    /// </summary>
    /// <param name="line">Digest of the label line. Lines are asked for in their order.</param>
    /// <param name="number">The number of the frame that it says; null if it cannot be read.</param>
    public ManifestFrame? Find(FileDigest line, int? number)
    {
        ManifestFrame? sameNumber = null;
        for (int i = 0; i < MaxAhead && At(i) is { } frame; i++)
        {
            if (frame.Label == line)
            {
                Passed += i;
                _ahead.RemoveRange(0, i);
                return Take(0);
            }

            sameNumber ??= frame.Frame == number ? frame : null;
        }

        return sameNumber;
    }

    /// <summary>Reads what follows the last frame that was asked for.</summary>
    public void ReadToEnd()
    {
        while (At(0) is not null)
        {
            Passed++;
            _ahead.RemoveAt(0);
        }
    }

    /// <inheritdoc />
    public void Dispose() => _lines.Dispose();

    private ManifestFrame Take(int index)
    {
        ManifestFrame frame = _ahead[index];
        _ahead.RemoveAt(index);
        return frame;
    }

    private ManifestFrame? At(int index)
    {
        while (_ahead.Count <= index && !_problems.IsFull && _lines.MoveNext())
        {
            _number++;
            try
            {
                Read(_lines.Current);
            }
            catch (DatasetFormatException e)
            {
                _problems.Add(new SessionProblem(Manifest.FileName, _number, e.Message));
            }
        }

        return index < _ahead.Count ? _ahead[index] : null;
    }

    private void Read(string line)
    {
        if (Manifest.FrameOf(line) is not null)
        {
            _ahead.Add(ManifestParser.Frame(line));
            return;
        }

        (string path, FileDigest digest) = ManifestParser.File(line);
        if (++_count > MaxFiles)
        {
            throw new DatasetFormatException($"there are more than {MaxFiles} lines of files that belong to no frame.");
        }

        if (!_files.TryGetValue(path, out List<FileDigest>? known))
        {
            known = [];
            _files.Add(path, known);
        }

        known.Add(digest);
    }
}
