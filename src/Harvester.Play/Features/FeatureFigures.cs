using System;
using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>What a feature has cost while it was on.</summary>
/// <param name="calls">Counts what is asked of the game.</param>
/// <param name="clock">The player's time.</param>
internal sealed class FeatureFigures(ICallCounter calls, IClock clock)
{
    private const double MillisecondsPerSecond = 1000;
    private readonly TickTimes _times = new();
    private readonly double _startMilliseconds = clock.Milliseconds;
    private long _natives;
    private long _rays;

    /// <summary>Adds a tick of the feature.</summary>
    /// <param name="before">What had been asked of the game, and when, just before it.</param>
    public void Add((long Natives, long Rays, double Milliseconds) before)
    {
        _natives += calls.Natives - before.Natives;
        _rays += calls.Rays - before.Rays;
        _times.Add(clock.Milliseconds - before.Milliseconds);
    }

    /// <summary>The figures in words, for the log.</summary>
    public override string ToString()
    {
        double seconds = (clock.Milliseconds - _startMilliseconds) / MillisecondsPerSecond;
        double nativesPerTick = _times.Count > 0 ? (double)_natives / _times.Count : 0;
        double raysPerSecond = seconds > 0 ? _rays / seconds : 0;
        string ticks = _times.Count == 1 ? "tick" : "ticks";
        return FormattableString.Invariant(
            $"{_times.Count} {ticks} in {seconds:0.0} s, {nativesPerTick:0.0} natives per tick, {raysPerSecond:0} rays per second, tick time p50 {_times.Percentile(0.5):0.00} ms, p99 {_times.Percentile(0.99):0.00} ms");
    }
}
