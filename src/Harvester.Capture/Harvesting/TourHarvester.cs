using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Harvests one frame at each place of a tour. A place that cannot be reached, or at which several frames were discarded, is left out.
/// </summary>
/// <param name="tour">The tour.</param>
/// <param name="frames">Harvests the frames.</param>
/// <param name="counters">Counts them.</param>
internal sealed class TourHarvester(IFrameTour tour, FrameHarvester frames, HarvestCounters counters)
{
    /// <summary>Attempts at a place: something may move into the first picture, and hardly into three.</summary>
    private const int MaxAttempts = 3;

    /// <summary>Visits all places.</summary>
    public IEnumerable<WorkStep> Run()
    {
        for (int place = 0; place < tour.Count; place++)
        {
            int taken = counters.Taken;
            int attempts = 0;
            while (counters.Taken == taken && attempts < MaxAttempts)
            {
                attempts++;
                yield return HarvestPhase.Travelling.Do(tour.Approach(place));

                if (tour.Obstacle is { } obstacle)
                {
                    counters.Discard(obstacle);
                    attempts = MaxAttempts;
                }
                else
                {
                    yield return WorkStep.Do(frames.HarvestOne());
                }

                tour.Leave();
            }
        }

        yield return WorkStep.Do(frames.Finish());
    }
}
