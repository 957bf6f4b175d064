namespace Harvester.Capture.Harvesting;

/// <summary>
/// Decides when a frame is due: at most once in each period of game time, counted from the first reading, so that errors do not accumulate.
/// </summary>
/// <param name="rateHz">Maximum number of frames per second.</param>
/// <param name="earlyFraction">Fraction of a period by which a frame may be early.</param>
internal sealed class FrameSchedule(double rateHz, double earlyFraction = 0)
{
    /// <summary>Fraction of a period by which a tick may be early, for a game whose time is a sum of rounded ticks.</summary>
    private const double Rounding = 1e-6;

    private double? _startSeconds;
    private long _nextPeriod;

    /// <summary>Whether a frame is due; if so, the period is used up.</summary>
    public bool TakeIfDue(double timeSeconds)
    {
        double start = _startSeconds ??= timeSeconds;
        long period = (long)Math.Floor(((timeSeconds - start) * rateHz) + earlyFraction + Rounding);
        if (period < _nextPeriod)
        {
            return false;
        }

        _nextPeriod = period + 1;
        return true;
    }

    /// <summary>Seconds until a frame is due; 0 or less if one is due now.</summary>
    public double SecondsUntilDue(double timeSeconds) =>
        _startSeconds is { } start ? start + ((_nextPeriod - earlyFraction) / rateHz) - timeSeconds : 0;
}
