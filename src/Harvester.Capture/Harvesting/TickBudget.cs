using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// The time that may be used in one tick. It is spent as soon as another step as long as the longest of the tick would exceed it.
/// </summary>
internal sealed class TickBudget(IClock clock, double milliseconds)
{
    /// <summary>
    /// Left for the mod's other work in a tick: two dozen natives where they are slowest, among them those of two lines of text.
    /// Of a small budget, at most half is left.
    /// </summary>
    private const double ReserveMilliseconds = 0.5;

    private readonly double _milliseconds = milliseconds - Math.Min(ReserveMilliseconds, milliseconds / 2);
    private double _tickStart;
    private double _stepStart;
    private double _longestStep;

    /// <summary>Whether the work should go on in the next tick; asked after each step.</summary>
    public bool IsSpent
    {
        get
        {
            double now = clock.Milliseconds;
            _longestStep = Math.Max(_longestStep, now - _stepStart);
            _stepStart = now;
            return now - _tickStart + _longestStep > _milliseconds;
        }
    }

    public void BeginTick()
    {
        _tickStart = clock.Milliseconds;
        BeginSteps();
    }

    /// <summary>Discards the duration of earlier steps: those that follow are of another kind.</summary>
    public void BeginSteps()
    {
        _stepStart = clock.Milliseconds;
        _longestStep = 0;
    }
}
