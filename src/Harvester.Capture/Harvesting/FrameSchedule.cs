using System;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Says when a frame is due: at most one in each period of the game's time, counted from the first reading, so that no error adds up.
/// </summary>
internal sealed class FrameSchedule(double rateHz)
{
    /// <summary>Share of a period by which a tick may come early, for a game whose time is a sum of rounded ticks.</summary>
    private const double Rounding = 1e-6;

    private double? _startSeconds;
    private long _nextPeriod;

    /// <summary>Whether a frame is due; a yes takes the period.</summary>
    public bool TakeIfDue(double timeSeconds)
    {
        double start = _startSeconds ??= timeSeconds;
        long period = (long)Math.Floor(((timeSeconds - start) * rateHz) + Rounding);
        if (period < _nextPeriod)
        {
            return false;
        }

        _nextPeriod = period + 1;
        return true;
    }

    /// <summary>Seconds until a frame is due; 0 or less when one is.</summary>
    public double SecondsUntilDue(double timeSeconds) => _startSeconds is { } start ? start + (_nextPeriod / rateHz) - timeSeconds : 0;
}
