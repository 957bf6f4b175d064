using System;
using System.Threading;
using System.Threading.Tasks;

namespace Harvester.Capture.Storage;

/// <summary>Writes to the disk one after the other on another thread than the game's. All calls come from one thread.</summary>
internal sealed class DiskQueue
{
    private Task _last = Task.CompletedTask;
    private Exception? _failure;

    public bool IsBusy => !_last.IsCompleted;

    public void Add(Action write) => _last = _last.ContinueWith(
        _ =>
        {
            try
            {
                write();
            }
#pragma warning disable CA1031 // It is told on the game's thread, whatever it is.
            catch (Exception exception)
#pragma warning restore CA1031
            {
                Interlocked.CompareExchange(ref _failure, exception, null);
            }
        },
        TaskScheduler.Default);

    /// <summary>The first failure since the last question; null without one.</summary>
    public Exception? TakeFailure() => Interlocked.Exchange(ref _failure, null);

    /// <summary>Waits until all is written, at most so long.</summary>
    public void Wait(TimeSpan longest) => _last.Wait(longest);
}
