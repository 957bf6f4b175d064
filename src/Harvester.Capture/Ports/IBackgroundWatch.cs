namespace Harvester.Capture.Ports;

/// <summary>Records or repeats what the game's thread learns about work on other threads.</summary>
public interface IBackgroundWatch
{
    /// <summary>Answers a question of <see cref="Background.IsDone"/>.</summary>
    bool IsDone(string what, Func<bool> isDone);
}
