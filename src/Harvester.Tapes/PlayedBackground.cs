using Harvester.Capture.Ports;

namespace Harvester.Tapes;

/// <summary>
/// Work on other threads appears done when it was done on the tape: earlier it is ignored, and where it is slower here it is waited for.
/// </summary>
/// <param name="tape">The tape.</param>
/// <param name="patience">How long work is waited for.</param>
internal sealed class PlayedBackground(TapeCursor tape, TimeSpan patience) : IBackgroundWatch
{
    /// <inheritdoc/>
    /// <exception cref="TapeStoppedException">The work does not end here, or the user ended the playback.</exception>
    public bool IsDone(string what, Func<bool> isDone)
    {
        if (tape.IsStopped || tape.TakeWork(what) is not { } wasDone)
        {
            return isDone();
        }

        if (wasDone)
        {
            Await(what, isDone);
        }

        return wasDone;
    }

    private void Await(string what, Func<bool> isDone)
    {
        bool isDoneHere = false;
        SpinWait.SpinUntil(() => tape.IsCancelled || (isDoneHere = isDone()), patience);
        if (!isDoneHere)
        {
            throw tape.IsCancelled
                ? new TapeStoppedException()
                : tape.Differ($"{what} done", FormattableString.Invariant($"{what} not done after {patience.TotalSeconds} s"));
        }
    }
}
