using Harvester.Geometry.Work;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Has one frame taken at each place of a tour. A place that cannot be reached, or at which several frames were discarded, is left out.
/// </summary>
/// <param name="tour">The tour.</param>
/// <param name="counters">Counts the frames.</param>
internal sealed class TourTrigger(IFrameTour tour, HarvestCounters counters) : IFrameTrigger
{
    /// <summary>Attempts at a place: something may move into the first picture, and hardly into three.</summary>
    private const int MaxAttempts = 3;

    private int _place;
    private int _attempts;
    private int _taken = counters.Taken;

    public bool IsFrameDue { get; private set; }

    public IEnumerable<WorkStep> Await()
    {
        IsFrameDue = false;
        while (!IsFrameDue)
        {
            if (counters.Taken != _taken || _attempts == MaxAttempts)
            {
                (_taken, _attempts) = (counters.Taken, 0);
                _place++;
            }

            if (_place >= tour.Count)
            {
                yield break;
            }

            _attempts++;
            yield return HarvestPhase.Travelling.Do(tour.Approach(_place));

            if (tour.Obstacle is { } obstacle)
            {
                counters.Discard(obstacle);
                _attempts = MaxAttempts;
                tour.Leave();
            }
            else
            {
                IsFrameDue = true;
            }
        }
    }

    public void Leave() => tour.Leave();
}
