using Harvester.Capture.Ports;

namespace Harvester.Play.Tapes;

/// <summary>Records the state of work on other threads.</summary>
/// <param name="tape">The recording.</param>
public sealed class TapedBackground(TapeRecorder tape) : IBackgroundWatch
{
    /// <inheritdoc/>
    public bool IsDone(string what, Func<bool> isDone)
    {
        bool answer = isDone();
        tape.Work(what, answer);
        return answer;
    }
}
