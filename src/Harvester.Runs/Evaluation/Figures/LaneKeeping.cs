namespace Harvester.Runs.Evaluation.Figures;

/// <summary>
/// Finds lane departures and lane changes. A part of the car beyond the lanes of its direction is a departure. A part of it on the adjacent
/// lane is a lane change if the car ends up there, a departure if it returns, and neither if a junction or the built-in driver intervenes.
/// </summary>
public sealed class LaneKeeping
{
    /// <summary>Time before and after a lane change in which the lateral error is not evaluated, seconds.</summary>
    private const double AroundChange = 4;

    private readonly IReadOnlyList<DriveSample> _samples;
    private readonly List<int> _departures = [];
    private readonly List<(int First, int Last)> _crossings = [];

    /// <summary>Evaluates the parts of a drive that the controller drove outside junctions.</summary>
    public LaneKeeping(IReadOnlyList<DriveSample> samples)
    {
        ArgumentNullException.ThrowIfNull(samples);
        _samples = samples;
        for (int i = 0; i < samples.Count; i++)
        {
            if (LaneOf(samples[i]) is { } placement && (placement.IsBeyondLanes || placement.IsOverLeft || placement.IsOverRight))
            {
                i = Judge(i);
            }
        }
    }

    /// <summary>Indices of the samples at which departures begin.</summary>
    public IReadOnlyList<int> Departures => _departures;

    /// <summary>Number of lane changes.</summary>
    public int Changes { get; private set; }

    /// <summary>Lateral errors of all samples not in or around a lane change, metres to the right of the lane centre.</summary>
    public IEnumerable<double> LateralErrors()
    {
        int crossing = 0;
        for (int i = 0; i < _samples.Count; i++)
        {
            while (crossing < _crossings.Count && i > _crossings[crossing].Last && !IsAround(i, _crossings[crossing].Last))
            {
                crossing++;
            }

            bool isChanging = crossing < _crossings.Count && (i >= _crossings[crossing].First || IsAround(i, _crossings[crossing].First));
            if (!isChanging && LaneOf(_samples[i]) is { Lane: not null } placement)
            {
                yield return placement.RightOfCentre;
            }
        }
    }

    private static LanePlacement? LaneOf(DriveSample sample) => sample.IsByController ? sample.Lane : null;

    private bool IsAround(int sample, int other) => Math.Abs(_samples[sample].TimeSeconds - _samples[other].TimeSeconds) < AroundChange;

    /// <summary>Follows the car from where it crosses a marking to where it no longer does.</summary>
    private int Judge(int first)
    {
        LanePlacement? before = first > 0 && !_samples[first].IsTeleported ? LaneOf(_samples[first - 1]) : null;
        bool isBeyond = false;
        int last = first;
        LanePlacement? after = null;
        for (int i = first; i < _samples.Count && !(i > first && _samples[i].IsTeleported); i++)
        {
            after = LaneOf(_samples[i]);
            if (after is null || !(after.IsBeyondLanes || after.IsOverLeft || after.IsOverRight))
            {
                break;
            }

            isBeyond |= after.IsBeyondLanes;
            last = i;
        }

        bool isSeenWhole = before is not null && after is not null && before.Road == after.Road;
        if (isBeyond || (isSeenWhole && before!.Lane == after!.Lane))
        {
            _departures.Add(first);
        }
        else
        {
            _crossings.Add((first, last));
            Changes += isSeenWhole ? 1 : 0;
        }

        return last;
    }
}
