using Harvester.Sessions.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Runs.Supervising;

/// <summary>
/// Judges the heartbeats of one start of a program. Durations are measured by a monotonic clock; the time in a heartbeat only has
/// to advance, and not to lie in the future.
/// </summary>
/// <param name="options">How patient it is.</param>
/// <param name="before">The reading before the program was started: a file with this content says nothing of the program.</param>
/// <param name="progress">The progress over all starts.</param>
public sealed class HeartbeatJudge(SupervisorOptions options, HeartbeatReading before, Progress progress)
{
    /// <summary>How far the time of a heartbeat may be ahead: clocks are set while a program runs.</summary>
    public static readonly TimeSpan FutureTolerance = TimeSpan.FromSeconds(30);

    private DateTime? _time;
    private string? _problem;
    private TimeSpan _advanced;
    private TimeSpan _progressed;
    private TimeSpan _starting;
    private TimeSpan? _ended;

    /// <summary>The last heartbeat of this start; null if there was none yet.</summary>
    public SeenHeartbeat? Last { get; private set; }

    /// <summary>Whether the program has said that nothing is left to do.</summary>
    public bool IsOver => Last?.State is HeartbeatState.Finished or HeartbeatState.Incomplete;

    /// <summary>Judges a reading.</summary>
    /// <param name="reading">The reading.</param>
    /// <param name="now">Time since the start.</param>
    /// <param name="utcNow">The time of day, UTC.</param>
    /// <param name="isOurs">Whether a process can be the program's.</param>
    /// <returns>What is wrong, as in "no heartbeat for 60 s"; null for nothing.</returns>
    public string? Judge(HeartbeatReading reading, TimeSpan now, DateTime utcNow, Func<int, bool> isOurs)
    {
        _problem = reading.Problem;
        if (reading.Heartbeat is { } heartbeat && !reading.IsSameAs(before))
        {
            if (LieIn(heartbeat, utcNow, isOurs) is { } lie)
            {
                return lie;
            }

            Receive(heartbeat, now);
        }

        return Last is null ? (now > options.StartTimeout ? $"no heartbeat within {Seconds(options.StartTimeout)}{Reason()}" : null)
            : Last.State == HeartbeatState.Starting
                ? now - _starting > options.StartTimeout ? $"still starting after {Seconds(options.StartTimeout)}"
                    : null
            : _ended is { } ended
                ? now - ended > options.Timeout ? $"its heartbeat says {JsonName.Of(Last.State)}, but the process goes on"
                    : null
            : now - _advanced > options.Timeout ? $"no new heartbeat for {Seconds(options.Timeout)}{Reason()}"
            : now - _progressed > options.Stall
                ? FormattableString.Invariant($"its heartbeat goes on, but it has been at frame {Last.Frames} for {Seconds(options.Stall)}")
            : null;
    }

    private string? LieIn(SeenHeartbeat heartbeat, DateTime utcNow, Func<int, bool> isOurs) =>
        heartbeat.Time > utcNow + FutureTolerance
            ? FormattableString.Invariant($"its heartbeat is {(heartbeat.Time - utcNow).TotalSeconds:0} s in the future")
        : !options.AllowsAnyProcess && !isOurs(heartbeat.Process)
            ? FormattableString.Invariant($"its heartbeat names process {heartbeat.Process}, which the command did not start")
        : null;

    private void Receive(SeenHeartbeat heartbeat, TimeSpan now)
    {
        if (_time is null || heartbeat.Time > _time)
        {
            _time = heartbeat.Time;
            _advanced = now;
        }

        bool isNew = Last is null || heartbeat.Frames != Last.Frames || heartbeat.Trial != Last.Trial;
        _starting = Last is null || (Last.State == HeartbeatState.Starting && heartbeat.Trial == Last.Trial) ? _starting : now;
        if (isNew || heartbeat.State != HeartbeatState.Running || Last!.State != HeartbeatState.Running)
        {
            _progressed = now;
        }

        _ended = heartbeat.State is HeartbeatState.Starting or HeartbeatState.Running ? null : _ended ?? now;
        Last = heartbeat;
        progress.Note(heartbeat);
    }

    private string Reason() => _problem is null ? "" : $". The file cannot be used: {_problem.TrimEnd('.')}";

    private static string Seconds(TimeSpan span) => FormattableString.Invariant($"{span.TotalSeconds:0.#} s");
}
