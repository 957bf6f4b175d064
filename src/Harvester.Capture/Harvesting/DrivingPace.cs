namespace Harvester.Capture.Harvesting;

/// <summary>
/// Measures by how much a harvest slows the game down: the real time from the first observation to the last, divided by the game time
/// between them.
/// </summary>
internal sealed class DrivingPace
{
    private const double MillisecondsPerSecond = 1000;

    /// <summary>With less game time the ratio is that of a single frame, seconds.</summary>
    private const double MinGameSeconds = 1;

    private (double Milliseconds, double GameSeconds)? _first;

    /// <summary>Real time for a second of game time, seconds; null until a second of game time has passed.</summary>
    public double? RealSecondsPerGameSecond { get; private set; }

    /// <summary>Takes a moment of the running game.</summary>
    /// <param name="milliseconds">Real time, from any start.</param>
    /// <param name="gameSeconds">The game's time.</param>
    public void Observe(double milliseconds, double gameSeconds)
    {
        _first ??= (milliseconds, gameSeconds);
        double passed = gameSeconds - _first.Value.GameSeconds;
        if (passed >= MinGameSeconds)
        {
            RealSecondsPerGameSecond = (milliseconds - _first.Value.Milliseconds) / MillisecondsPerSecond / passed;
        }
    }
}
