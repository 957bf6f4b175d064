using Harvester.Capture.Ports;

namespace Harvester.Play.Features;

/// <summary>
/// A resource that takes long to open and close, such as a disk or a network: both are done on another thread, in order. All calls come
/// from one thread.
/// </summary>
/// <typeparam name="T">The resource.</typeparam>
internal sealed class SlowResource<T>
    where T : class, IDisposable
{
    private readonly string _name = typeof(T).Name;
    private Task<T>? _opening;
    private Task _closing = Task.CompletedTask;

    /// <summary>Whether it is open or about to be.</summary>
    public bool IsHeld => _opening is not null;

    /// <summary>Whether it is being opened or closed.</summary>
    public bool IsBusy => !Background.IsDone(_name, () => _opening is not { IsCompleted: false } && _closing.IsCompleted);

    /// <summary>The open resource; null if it is not open, or not yet.</summary>
    public T? Opened =>
        _opening is { } opening && Background.IsDone(_name, () => opening.Status == TaskStatus.RanToCompletion) ? opening.Result : null;

    /// <summary>Opens it, after the one before has been closed.</summary>
    public void Open(Func<T> open) => _opening = _closing.ContinueWith(_ => open(), TaskScheduler.Default);

    /// <summary>Why it could not be opened, returned once; it is then no longer held. Null without a failure.</summary>
    public Exception? TakeFailure()
    {
        if (_opening is not { IsFaulted: true } failed)
        {
            return null;
        }

        _opening = null;
        return failed.Exception!.InnerException;
    }

    /// <summary>Closes it as soon as it is open. Calling it again has no effect.</summary>
    public void Close()
    {
        if (_opening is { } opening)
        {
            _opening = null;
            _closing = opening.ContinueWith(
                static opened => (opened.Status == TaskStatus.RanToCompletion ? opened.Result : null)?.Dispose(),
                TaskScheduler.Default
            );
        }
    }

    /// <summary>Waits until it is closed, or until the time is over.</summary>
    public void Wait(TimeSpan timeout) => _closing.Wait(timeout);
}
