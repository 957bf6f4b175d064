using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// Notices times in which the game gave scripts no tick: it pauses without the focus, in its menu and while it loads. The work of the mod
/// itself does not count.
/// </summary>
/// <param name="messages">Logs a gap; shows it if something was running.</param>
/// <param name="clock">Real time, which never goes back.</param>
/// <param name="isRunning">Whether a harvest, a drive or a plan is running, which the gap interrupted.</param>
public sealed class TickGaps(PlayerMessages messages, IClock clock, Func<bool> isRunning)
{
    /// <summary>A longer time between two ticks is a gap, milliseconds; a slow game still ticks ten times within it.</summary>
    private const double MaxUsualMilliseconds = 1000;

    private const double MillisecondsPerSecond = 1000;
    private double? _endedAt;

    /// <summary>Called when a tick begins.</summary>
    public void Begin()
    {
        double gap = clock.Milliseconds - _endedAt ?? 0;
        if (gap <= MaxUsualMilliseconds)
        {
            return;
        }

        string seconds = FormattableString.Invariant($"No tick for {gap / MillisecondsPerSecond:0.0} s: the game was paused");
        if (isRunning())
        {
            messages.Tell($"{seconds}. Switch off Pause Game On Focus Loss under Settings, Graphics, and stay out of the menus meanwhile.");
        }
        else
        {
            messages.Log($"{seconds} or loading.");
        }
    }

    /// <summary>Called when the work of a tick is done.</summary>
    public void End() => _endedAt = clock.Milliseconds;
}
