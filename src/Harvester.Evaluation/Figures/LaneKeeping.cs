using System;
using System.Collections.Generic;

namespace Harvester.Evaluation.Figures;

/// <summary>
/// Finds where a car left its lane and where it changed lanes. A part of the car beyond the lanes of its direction is a departure. A part
/// of it on the lane beside is a change of lane if the car ends up there, a departure too if it comes back, and neither if a junction or
/// the own driver puts an end to it.
/// </summary>
public sealed class LaneKeeping
{
    /// <summary>Before and after a change of lane the car is not meant to be in the middle of one, seconds.</summary>
    private const double AroundChange = 4;

    private readonly IReadOnlyList<DriveSample> _samples;
    private readonly List<int> _departures = [];
    private readonly List<(int First, int Last)> _crossings = [];

    /// <summary>Judges the stretches of a drive that the controller drove outside of junctions.</summary>
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

    /// <summary>Numbers of the samples with which departures begin.</summary>
    public IReadOnlyList<int> Departures => _departures;

    /// <summary>How many changes of lane there were.</summary>
    public int Changes { get; private set; }

    /// <summary>Metres to the right of the middle of the lane, of every sample that is neither in nor around a change of lane.</summary>
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

    /// <summary>Follows the car from where it is over a marking to where it is not.</summary>
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
