using System;
using System.Collections.Generic;
using System.Text.Json;
using System.Threading;
using Harvester.Datasets.Reports;
using Harvester.Datasets.Sessions;
using Harvester.Datasets.Statistics;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Viewing;

/// <summary>
/// What is known about all frames that have been read so far: blocks of numbers, the objects, events, and statistics. One thread adds
/// frames, others read.
/// </summary>
/// <param name="views">Names of the rig's cameras; empty without one.</param>
internal sealed class Overview(IReadOnlyList<string> views)
{
    private readonly Lock _lock = new();
    private readonly List<byte[]> _blocks = [];
    private readonly List<OverviewFrame> _open = [];
    private readonly List<List<ObjectLabel>> _firstSeen = [[]];
    private readonly HashSet<int> _known = [];
    private readonly List<(int Index, string Text)> _events = [];
    private readonly SessionStatistics _statistics = SessionStatistics.Of(Array.Empty<FrameLabel>());
    private FrameLabel? _last;

    /// <summary>Number of frames, including those that cannot be read.</summary>
    public int Count { get; private set; }

    /// <summary>Number of lines that cannot be read.</summary>
    public int Problems { get; private set; }

    /// <summary>The first problem of a line; null for none.</summary>
    public string? FirstProblem { get; private set; }

    /// <summary>Adds the next frame.</summary>
    /// <exception cref="Files.DatasetFormatException">The label cannot be counted.</exception>
    public void Add(FrameLabel label)
    {
        lock (_lock)
        {
            _statistics.Add(label);
            foreach (string text in FrameEvents.Between(_last, label))
            {
                _events.Add((Count, text));
            }

            _last = label;
            foreach (ObjectLabel item in label.Objects)
            {
                if (_known.Add(item.Id))
                {
                    _firstSeen[^1].Add(item);
                }
            }

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
            return number < 0 ? null : number < _blocks.Count ? _blocks[number]
                : number == _blocks.Count && _open.Count > 0 ? OverviewBlock.Encode(_open) : null;
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
        Count++;
        if (_open.Count == OverviewBlock.Frames)
        {
            _blocks.Add(OverviewBlock.Encode(_open));
            _firstSeen.Add([]);
            _open.Clear();
        }
    }
}
