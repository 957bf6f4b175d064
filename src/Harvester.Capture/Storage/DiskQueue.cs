namespace Harvester.Capture.Storage;

/// <summary>
/// Runs disk operations in order on a thread of its own, so that the game's thread never waits. All calls come from one thread.
/// </summary>
internal sealed class DiskQueue
{
    private Task _last = Task.CompletedTask;
    private Exception? _failure;

    public bool IsBusy => !_last.IsCompleted;

    public void Add(Action write) =>
        _last = _last.ContinueWith(
            _ =>
            {
                try
                {
                    write();
                }
#pragma warning disable CA1031 // Any failure is reported on the game's thread.
                catch (Exception exception)
#pragma warning restore CA1031
                {
                    Interlocked.CompareExchange(ref _failure, exception, null);
                }
            },
            TaskScheduler.Default
        );

    /// <summary>The first failure since the last call; null if there was none.</summary>
    public Exception? TakeFailure() => Interlocked.Exchange(ref _failure, null);

    /// <summary>Waits until all operations are done, or until the time is over.</summary>
    public void Wait(TimeSpan timeout) => _last.Wait(timeout);
}
