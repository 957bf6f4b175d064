namespace Harvester.Runs.Driving;

/// <summary>
/// Paces the ticks of a game in real time. Delays, of a slow machine or a frozen world, are not made up for later.
/// </summary>
/// <param name="tickSeconds">Game time of a tick, seconds.</param>
/// <param name="clock">Real time.</param>
public sealed class WallPace(double tickSeconds, TimeProvider clock)
{
    /// <summary>Interval at which a frozen world handles messages of its client.</summary>
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(1);

    private readonly TimeSpan _tick = TimeSpan.FromSeconds(tickSeconds);
    private readonly long _start = clock.GetTimestamp();
    private TimeSpan _due;

    /// <summary>Waits until the next tick is due.</summary>
    /// <param name="isFrozen">Whether the world is frozen; then only messages are handled.</param>
    /// <param name="isHurried">Whether it is due at once, as in a single step.</param>
    /// <param name="cancellation">Ends the wait.</param>
    public void Wait(bool isFrozen, bool isHurried, CancellationToken cancellation)
    {
        TimeSpan wait = NextWait(isFrozen, isHurried);
        if (wait > TimeSpan.Zero)
        {
            cancellation.WaitHandle.WaitOne(wait);
        }
    }

    /// <summary>The time until the next tick is due; the tick then counts as taken.</summary>
    internal TimeSpan NextWait(bool isFrozen, bool isHurried)
    {
        if (isFrozen)
        {
            return Poll;
        }

        TimeSpan now = clock.GetElapsedTime(_start);
        _due += _tick;
        _due = isHurried || _due < now ? now : _due;
        return _due - now;
    }
}
