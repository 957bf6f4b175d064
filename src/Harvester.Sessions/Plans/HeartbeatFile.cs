using System.Diagnostics;
using Harvester.Sessions.Files;

namespace Harvester.Sessions.Plans;

/// <summary>
/// The file by which others see whether a plan still runs. It is written on another thread, at most once a second, and appears whole. A
/// failure to write it is ignored: it is of no use but to an observer, who sees that it is old. All calls come from one thread.
/// </summary>
/// <param name="folder">The folder of the plan's output.</param>
/// <param name="plan">Name of the plan.</param>
/// <param name="shard">The part of the plan; a shard has a file of its own.</param>
public sealed class HeartbeatFile(string folder, string plan, Shard shard)
{
    private static readonly TimeSpan Interval = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan MaxWait = TimeSpan.FromSeconds(2);
#if NET
    private readonly int _process = Environment.ProcessId;
#else
    private readonly int _process = Process.GetCurrentProcess().Id;
#endif
    private readonly string _name = Heartbeat.FileNameOf(shard);
    private readonly Stopwatch _sinceLast = new();
    private Task _writing = Task.CompletedTask;
    private bool _isClean;

    /// <summary>Whether a sign of life is still being written.</summary>
    public bool IsBusy => !_writing.IsCompleted;

    /// <summary>Gives a sign of life, unless the last one is younger than a second or still being written.</summary>
    public void Beat(HeartbeatState state, string? trial, int frames)
    {
        if ((!_sinceLast.IsRunning || _sinceLast.Elapsed >= Interval) && _writing.IsCompleted)
        {
            _sinceLast.Restart();
            Write(state, trial, frames);
        }
    }

    /// <summary>Gives the last sign of life, after those before it.</summary>
    public void End(HeartbeatState state, int frames) => Write(state, null, frames);

    /// <summary>Waits until the last sign of life is written, or for two seconds.</summary>
    public void Wait() => _writing.Wait(MaxWait);

    private void Write(HeartbeatState state, string? trial, int frames)
    {
        string text = new Heartbeat(_process, DateTime.UtcNow, state, plan, trial, frames).ToJson();
        _writing = _writing.ContinueWith(
            _ =>
            {
                try
                {
                    if (!_isClean)
                    {
                        // What a program left that was stopped while it wrote.
                        AtomicFile.DeleteLeftovers(folder, name => name == _name);
                        _isClean = true;
                    }

                    AtomicFile.Write(Path.Combine(folder, _name), text, isDurable: false);
                }
                catch (Exception e) when (e is IOException or UnauthorizedAccessException)
                {
                    return;
                }
            },
            TaskScheduler.Default
        );
    }
}
