using System.Diagnostics;
using System.Globalization;
using System.Runtime.InteropServices;
using Harvester.Runs.Ports;
using Harvester.Sessions.Plans;

namespace Harvester.Runs.Supervising;

/// <summary>
/// Starts a program, watches its heartbeat, and restarts it when it hangs, crashes or reports a false state, until it has finished.
/// </summary>
public sealed class Supervisor(SupervisorOptions options, IRunLog log, IStopSignal signal)
{
    // One second less than what is left to this program after a signal.
    private static readonly TimeSpan StopPatience = TimeSpan.FromSeconds(4);
    private static readonly TimeSpan SharedSignalPatience = TimeSpan.FromSeconds(2);

    private readonly Progress _progress = new();
    private bool _isIncomplete;

    /// <summary>Supervises until the program has finished, too many restarts bring nothing, or a signal comes.</summary>
    /// <exception cref="System.IO.IOException">The program cannot be started.</exception>
    public SupervisorEnd Run(CancellationToken cancellation)
    {
        int vain = 0;
        for (bool isRestart = false; ; isRestart = true)
        {
            if (Watch(isRestart, cancellation) is not { } fault)
            {
                return Ending();
            }

            if (cancellation.IsCancellationRequested)
            {
                return SupervisorEnd.Cancelled;
            }

            vain = _progress.Take() ? 1 : vain + 1;
            if (vain > options.MaxRestarts)
            {
                Log($"{fault}; given up");
                log.Warn(
                    $"Given up after {options.MaxRestarts} restarts without a new frame. The last time, {fault}. Look at the program's own "
                        + "messages; what it wrote is valid."
                );
                return SupervisorEnd.GivenUp;
            }

            TimeSpan delay = options.DelayOf(vain);
            Log(
                FormattableString.Invariant($"{fault}; restart {vain} of at most {options.MaxRestarts} in a row without progress ")
                    + FormattableString.Invariant($"follows in {delay.TotalSeconds:0.##} s")
            );
            if (cancellation.WaitHandle.WaitOne(delay))
            {
                return SupervisorEnd.Cancelled;
            }
        }
    }

    /// <summary>Watches one start of the program.</summary>
    /// <returns>Why it has to be started again; null if it has finished.</returns>
    private string? Watch(bool isRestart, CancellationToken cancellation)
    {
        var judge = new HeartbeatJudge(options, HeartbeatReader.Read(options.HeartbeatPath), _progress);
        ProcessStartInfo start = StartOf(isRestart);
        using SupervisedProcess process = SupervisedProcess.Start(start);
        Log($"started process {Text(process.Id)}: {string.Join(' ', start.ArgumentList.Prepend(start.FileName).Select(ShellWord.Of))}");
        var time = Stopwatch.StartNew();
        while (true)
        {
            // What has ended cannot write any more: the reading that follows is its last word.
            bool hasEnded = process.HasEnded;
            HeartbeatReading reading = HeartbeatReader.Read(options.HeartbeatPath);
            string? fault = judge.Judge(reading, time.Elapsed, DateTime.UtcNow, process.IsOurs);

            // With any process, the number is that of another system.
            bool isLeft = hasEnded && judge.Last is { } heard && !options.AllowsAnyProcess && process.TryAdopt(heard.Process);
            if (judge.IsOver && (fault is not null || (hasEnded && !isLeft)))
            {
                return Finish(process, judge.Last!, hasEnded && !isLeft);
            }

            if (hasEnded && !isLeft && !IsLauncherOf(process, judge.Last))
            {
                // What the program has started would stand in the way of the next start.
                process.End();
                return $"process {Text(process.Id)} crashed: it ended ({process.Ending}) before its heartbeat said finished";
            }

            if (fault is not null)
            {
                string what = $"process {Text(process.Id)} was ended: {fault}";
                process.End();
                return what;
            }

            if (cancellation.WaitHandle.WaitOne(options.Poll))
            {
                Stop(process);
                return "a signal came";
            }
        }
    }

    /// <summary>Whether a command that has ended is a launcher, whose program gives signs of life or may still do so.</summary>
    private bool IsLauncherOf(SupervisedProcess process, SeenHeartbeat? last) =>
        options.IsLauncher && process.IsCommand && (last is null || options.AllowsAnyProcess);

    /// <summary>Ends a program that has nothing left to do, if it goes on all the same.</summary>
    /// <returns>Null: it is not started again.</returns>
    private string? Finish(SupervisedProcess process, SeenHeartbeat last, bool hasEnded)
    {
        if (!hasEnded)
        {
            process.End();
        }

        string how = hasEnded ? process.Ending : "it went on and was ended";
        Log($"process {Text(process.Id)} has finished ({how}), frames: {Text(last.Frames)}");
        _isIncomplete = last.State == HeartbeatState.Incomplete;
        return null;
    }

    private SupervisorEnd Ending()
    {
        if (_isIncomplete)
        {
            log.Warn("It has finished, but trials were skipped; plan-status.jsonl names them.");
        }

        return _isIncomplete ? SupervisorEnd.Incomplete : SupervisorEnd.Finished;
    }

    private void Stop(SupervisedProcess process)
    {
        Log($"stopping process {Text(process.Id)}");
        PosixSignal last = signal.Signal;
        bool hasEnded = false;
        if (signal.IsShared)
        {
            hasEnded = process.WaitForEnd(SharedSignalPatience, last);
            last = PosixSignal.SIGTERM;
        }

        if (!hasEnded)
        {
            process.Send(last);
            hasEnded = process.WaitForEnd(StopPatience - (signal.IsShared ? SharedSignalPatience : TimeSpan.Zero), last);
        }

        if (!hasEnded)
        {
            process.End();
            Log($"process {Text(process.Id)}, or one that it started, did not end by itself and was ended");
        }
    }

    private ProcessStartInfo StartOf(bool isRestart)
    {
        var start = new ProcessStartInfo(options.Program) { UseShellExecute = false };
        foreach (string argument in options.Arguments)
        {
            start.ArgumentList.Add(argument);
        }

        if (isRestart && options.RestartArgument is { } added && !options.Arguments.Contains(added))
        {
            start.ArgumentList.Add(added);
        }

        return start;
    }

    private void Log(string line)
    {
        log.Note(string.Create(CultureInfo.InvariantCulture, $"{DateTime.UtcNow:yyyy-MM-dd'T'HH:mm:ss'Z'} {line}"));
    }

    private static string Text(long number) => number.ToString(CultureInfo.InvariantCulture);
}
