using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>Has frames taken at a rate, while the game runs, up to a maximum number.</summary>
/// <param name="options">Rate and maximum.</param>
/// <param name="time">Reads the game's time.</param>
/// <param name="counters">Counts the frames.</param>
/// <param name="calls">Counts the calls to the game.</param>
internal sealed class RateTrigger(HarvestOptions options, HarvestTime time, HarvestCounters counters, PhaseCalls calls) : IFrameTrigger
{
    private readonly FrameSchedule _schedule = new(options.RateHz, options.EarlyFraction);

    public bool IsFrameDue { get; private set; }

    public IEnumerable<WorkStep> Await()
    {
        bool needsTick = IsFrameDue;
        IsFrameDue = false;
        if (counters.Taken == options.MaxFrames)
        {
            yield break;
        }

        while (!IsFrameDue)
        {
            if (needsTick)
            {
                yield return HarvestPhase.Waiting.Tick();
            }

            needsTick = true;
            time.ReadRunning();
            calls.Charge(HarvestPhase.Waiting);
            IsFrameDue = _schedule.TakeIfDue(time.Seconds);
        }
    }

    public void Leave() { }
}
