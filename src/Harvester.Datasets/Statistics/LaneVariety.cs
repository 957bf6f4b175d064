using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Statistics;

/// <summary>How much a network for the lane indicators can learn from a session: frames whose lanes are known.</summary>
public sealed class LaneVariety
{
    /// <summary>The indicators that only a road with a neighbouring lane of the same direction has.</summary>
    private static readonly HashSet<string> OfNeighbours = ["toMarkingLL", "toMarkingRR", "distLL", "distRR"];

    private readonly int[] _active = new int[IndicatorTable.Count];
    private int _frames;
    private int _framesWithNeighbours;
    private double _mean;
    private double _squares;

    /// <summary>Number of frames whose lanes are known.</summary>
    public int Frames => _frames;

    /// <summary>Standard deviation of the car's offset from the middle of its lane, metres; 0 without frames.</summary>
    public double OffsetDeviationMetres => _frames == 0 ? 0 : Math.Sqrt(_squares / _frames);

    /// <summary>Smallest offset from the middle of the lane, metres, negative to the left; 0 without frames.</summary>
    public double MinOffsetMetres { get; private set; }

    /// <summary>Largest offset from the middle of the lane, metres; 0 without frames.</summary>
    public double MaxOffsetMetres { get; private set; }

    /// <summary>
    /// Number of frames whose road has what an indicator measures: those whose lanes are known and, for the neighbouring lanes, that have
    /// two lanes or more in the car's direction.
    /// </summary>
    /// <param name="indicator">Its position in <see cref="IndicatorTable"/>.</param>
    public int FramesWith(int indicator) => OfNeighbours.Contains(IndicatorTable.All[indicator].Name) ? _framesWithNeighbours : _frames;

    /// <summary>Fraction of these frames in which the indicator is active, 0 to 1; 0 without frames.</summary>
    /// <param name="indicator">Its position in <see cref="IndicatorTable"/>.</param>
    public double ActiveFraction(int indicator) => FramesWith(indicator) == 0 ? 0 : (double)_active[indicator] / FramesWith(indicator);

    internal void Add(LanesLabel lanes)
    {
        if (lanes is not { Status: LaneStatus.Known, OffsetFromLaneCentreMetres: { } offset, LaneCount: { } count })
        {
            return;
        }

        MinOffsetMetres = _frames == 0 ? offset : Math.Min(MinOffsetMetres, offset);
        MaxOffsetMetres = _frames == 0 ? offset : Math.Max(MaxOffsetMetres, offset);
        _frames++;
        _framesWithNeighbours += count > 1 ? 1 : 0;

        // The method of Welford (1962), exact for long sessions too.
        double difference = offset - _mean;
        _mean += difference / _frames;
        _squares += difference * (offset - _mean);
        for (int i = 0; i < _active.Length; i++)
        {
            bool isOfRoad = count > 1 || !OfNeighbours.Contains(IndicatorTable.All[i].Name);
            _active[i] += isOfRoad && IndicatorTable.All[i].Of(lanes.Indicators).IsValid ? 1 : 0;
        }
    }
}
