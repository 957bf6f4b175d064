using System.Text.Json;
using Harvester.Datasets.Statistics;
using Harvester.Reports.Sessions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Reports.Viewing;

/// <summary>
/// What is known about all frames that have been read so far: blocks of numbers, the objects, events, and statistics. One thread adds
/// frames, others read.
/// </summary>
/// <param name="views">Names of the rig's cameras; empty without one.</param>
internal sealed class Overview(IReadOnlyList<string> views)
{
    /// <summary>What blocks, objects and events may take together, bytes; an estimate within a factor of 2.</summary>
    public const int MaxBytes = 512 << 20;

    /// <summary>Lines that cannot be read, after which the reading stops.</summary>
    public const int MaxProblems = 1000;

    // A pair of numbers and references, and a character, in memory.
    private const int EventBytes = 64;
    private const int CharacterBytes = sizeof(char);

    private readonly Lock _lock = new();
    private readonly List<byte[]> _blocks = [];
    private readonly List<OverviewFrame> _open = [];
    private readonly List<List<ObjectLabel>> _firstSeen =
    [
        [],
    ];
    private readonly HashSet<int> _known = [];
    private readonly List<(int Index, string Text)> _events = [];
    private readonly SessionStatistics _statistics = SessionStatistics.Of(Array.Empty<FrameLabel>());
    private FrameLabel? _last;
    private long _bytes;

    /// <summary>Why no further frames are to be added, a sentence; null if they may be.</summary>
    public string? Limit =>
        Problems >= MaxProblems ? $"Reading stopped after {MaxProblems} such lines. Check the session with 'harvester validate'."
        : _bytes >= MaxBytes ? $"Filters, plots and statistics cover the first {Count} frames, the most that the viewer keeps in memory."
        : null;

    /// <summary>Number of frames, including those that cannot be read.</summary>
    public int Count { get; private set; }

    /// <summary>Number of lines that cannot be read.</summary>
    public int Problems { get; private set; }

    /// <summary>The first problem of a line; null for none.</summary>
    public string? FirstProblem { get; private set; }

    /// <summary>Adds the next frame.</summary>
    /// <param name="label">Its label.</param>
    /// <param name="lineBytes">Length of its line, bytes.</param>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">The label cannot be counted.</exception>
    public void Add(FrameLabel label, int lineBytes)
    {
        lock (_lock)
        {
            _statistics.Add(label);
            foreach (string text in FrameEvents.Between(_last, label))
            {
                _events.Add((Count, text));
                _bytes += EventBytes + CharacterBytes * text.Length;
            }

            _last = label;
            int known = _known.Count;
            foreach (ObjectLabel item in label.Objects)
            {
                if (_known.Add(item.Id))
                {
                    _firstSeen[^1].Add(item);
                }
            }

            // New objects are kept whole: their share of the line.
            _bytes += (long)lineBytes * (_known.Count - known) / Math.Max(1, label.Objects.Count);

            Append(OverviewFrame.Of(label, views));
        }
    }

    /// <summary>Adds a frame that cannot be read: it has no objects, and no values but its place in the file.</summary>
    public void AddProblem(string problem)
    {
        lock (_lock)
        {
            Problems++;
            FirstProblem ??= problem;
            float[] none = new float[OverviewFrame.ValueCount];
            Array.Fill(none, float.NaN);
            int frame = _last is null ? 0 : _last.Frame;
            Append(new OverviewFrame(frame, _last?.Moment ?? frame, 0, none, []));
        }
    }

    /// <summary>A block; null if no frame of it has been read.</summary>
    public byte[]? Block(int number)
    {
        lock (_lock)
        {
            return number < 0 ? null
                : number < _blocks.Count ? _blocks[number]
                : number == _blocks.Count && _open.Count > 0 ? OverviewBlock.Encode(_open)
                : null;
        }
    }

    /// <summary>Writes the objects first seen in a block; none if it has not been read.</summary>
    public void WriteObjects(Utf8JsonWriter json, int block)
    {
        lock (_lock)
        {
            ReportData.WriteObjects(json, block >= 0 && block < _firstSeen.Count ? _firstSeen[block] : []);
        }
    }

    /// <summary>Writes the statistics and the events so far as fields of the current object.</summary>
    public void WriteFigures(Utf8JsonWriter json, SessionInfo info)
    {
        lock (_lock)
        {
            ReportFigures.Write(json, info, _statistics);
            FrameEvents.Write(json, _events);
        }
    }

    private void Append(OverviewFrame frame)
    {
        _open.Add(frame);
        _bytes += frame.Bytes;
        Count++;
        if (_open.Count == OverviewBlock.Frames)
        {
            _blocks.Add(OverviewBlock.Encode(_open));
            _firstSeen.Add([]);
            _open.Clear();
        }
    }
}
