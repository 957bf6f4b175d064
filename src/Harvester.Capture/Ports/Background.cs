namespace Harvester.Capture.Ports;

/// <summary>
/// What the game's thread asks about work on other threads. The answers depend on the speed of the machine, so a tape records them and a
/// playback repeats them.
/// </summary>
public static class Background
{
    [ThreadStatic]
    private static IBackgroundWatch? _watch;

    /// <summary>Records or repeats the answers on this thread; null while nobody does.</summary>
    public static IBackgroundWatch? Watch
    {
        get => _watch;
        set => _watch = value;
    }

    /// <summary>Whether work on another thread is done, or a queue to it takes something.</summary>
    /// <param name="what">Name of the work.</param>
    /// <param name="isDone">Asks; a playback may repeat the question until the answer is yes.</param>
    public static bool IsDone(string what, Func<bool> isDone) =>
        _watch is { } watch ? watch.IsDone(what, isDone) : (isDone ?? throw new ArgumentNullException(nameof(isDone)))();
}
