using System;
using System.Threading;

namespace Harvester.Cli.Driving;

/// <summary>
/// Keeps the ticks of a game to the clock on the wall. A machine that is too slow for the pace, and a world that has stood, do not hurry
/// later.
/// </summary>
/// <param name="tickSeconds">The game's time from tick to tick.</param>
/// <param name="clock">The clock on the wall.</param>
internal sealed class WallPace(double tickSeconds, TimeProvider clock)
{
    /// <summary>A world that stands hears its client so often.</summary>
    private static readonly TimeSpan Poll = TimeSpan.FromMilliseconds(1);

    private readonly TimeSpan _tick = TimeSpan.FromSeconds(tickSeconds);
    private readonly long _start = clock.GetTimestamp();
    private TimeSpan _due;

    /// <summary>Waits until the next tick is due.</summary>
    /// <param name="isStanding">Whether the world stands still; only the client is heard then.</param>
    /// <param name="isHurried">Whether it is due at once.</param>
    /// <param name="cancellation">Ends the waiting.</param>
    public void Wait(bool isStanding, bool isHurried, CancellationToken cancellation)
    {
        TimeSpan wait = NextWait(isStanding, isHurried);
        if (wait > TimeSpan.Zero)
        {
            cancellation.WaitHandle.WaitOne(wait);
        }
    }

    /// <summary>How long it is until the next tick is due; it counts as done then.</summary>
    internal TimeSpan NextWait(bool isStanding, bool isHurried)
    {
        if (isStanding)
        {
            return Poll;
        }

        TimeSpan now = clock.GetElapsedTime(_start);
        _due += _tick;
        _due = isHurried || _due < now ? now : _due;
        return _due - now;
    }
}
