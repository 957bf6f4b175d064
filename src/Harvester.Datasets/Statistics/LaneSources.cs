using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Statistics;

/// <summary>Where the geometry of lanes comes from: frames whose lanes are known, and the lane lines in them.</summary>
public sealed class LaneSources
{
    private readonly SortedDictionary<LaneWidthSource, int> _frames = [];
    private readonly SortedDictionary<LaneWidthSource, int> _lines = [];

    /// <summary>Number of frames whose lanes have each source; only sources that occur.</summary>
    public IReadOnlyDictionary<LaneWidthSource, int> Frames => _frames;

    /// <summary>
    /// Number of lane lines of each source: measured markings are paint, boundaries have the source of the label's lane width. Markings
    /// that the game itself reports are in <see cref="ExactLines"/> instead.
    /// </summary>
    public IReadOnlyDictionary<LaneWidthSource, int> Lines => _lines;

    /// <summary>Number of markings that the game itself reports, as the simulated game does.</summary>
    public int ExactLines { get; private set; }

    internal void Add(LanesLabel lanes)
    {
        if (lanes is not { Status: LaneStatus.Known, LaneWidthSource: { } source })
        {
            return;
        }

        _frames[source] = _frames.GetValueOrDefault(source) + 1;
        foreach (LaneLineView line in lanes.Lines)
        {
            if (line is { Paint: not null, SigmaMetres: null })
            {
                ExactLines++;
                continue;
            }

            LaneWidthSource ofLine = line.SigmaMetres is null ? source : LaneWidthSource.Paint;
            _lines[ofLine] = _lines.GetValueOrDefault(ofLine) + 1;
        }
    }
}
