using Harvester.Capture.Ports;
using Harvester.Sessions.Text;

namespace Harvester.Play.Features;

/// <summary>The cost of a feature while it was on.</summary>
/// <param name="calls">Counts the calls to the game.</param>
/// <param name="clock">Real time.</param>
internal sealed class FeatureFigures(ICallCounter calls, IClock clock)
{
    private const double MillisecondsPerSecond = 1000;
    private readonly TickTimes _times = new();
    private readonly double _startMilliseconds = clock.Milliseconds;
    private long _natives;
    private long _rays;

    /// <summary>Adds a tick of the feature.</summary>
    /// <param name="before">The counts of calls and the time just before the tick.</param>
    public void Add((long Natives, long Rays, double Milliseconds) before)
    {
        _natives += calls.Natives - before.Natives;
        _rays += calls.Rays - before.Rays;
        _times.Add(clock.Milliseconds - before.Milliseconds);
    }

    /// <summary>The figures as text, for the log.</summary>
    public override string ToString()
    {
        double seconds = (clock.Milliseconds - _startMilliseconds) / MillisecondsPerSecond;
        double nativesPerTick = _times.Count > 0 ? (double)_natives / _times.Count : 0;
        double raysPerSecond = seconds > 0 ? _rays / seconds : 0;
        string ticks = Counted.Of(_times.Count, "tick");
        return FormattableString.Invariant($"{ticks} in {seconds:0.0} s, {nativesPerTick:0.0} natives per tick, ")
            + FormattableString.Invariant($"{raysPerSecond:0} rays per second, ")
            + FormattableString.Invariant($"tick time p50 {_times.Percentile(0.5):0.00} ms, p99 {_times.Percentile(0.99):0.00} ms");
    }
}
