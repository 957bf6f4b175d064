using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry.Work;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Text;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Measures the number of ticks by which the picture lags behind the state: it freezes a moving game, observes both, and finds the shift by
/// which the changes of the picture follow the movement (<see cref="LagRecord"/>). A single freeze may mislead, as when the world creeps on
/// by less than a picture shows, so the same lag must be found several times, and more often than all others.
/// </summary>
internal sealed class LagProbe(HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool)
{
    /// <summary>Changes of the picture that are observed before the freeze, so that the movement itself is recorded.</summary>
    private const int RunningTicks = 4;

    private const int Agreement = 3;
    private const int MaxAttempts = 20;

    /// <summary>Number of failed attempts after which a harvest that does not need the lag continues without it.</summary>
    private const int VainAttemptsOfCheck = 2;

    private readonly SceneComparison _comparison = new(options.StillToleranceMetres);

    /// <summary>Whether the lag is known to be within the limit of the options; otherwise greater lags are looked for too.</summary>
    public bool IsLagWithinLimit { get; init; }

    private int MaxTicks => IsLagWithinLimit ? options.MaxPictureLagTicks : PictureLag.MaxTicks;

    /// <summary>Long enough to see the latest change that is looked for, and after it the noise of the picture.</summary>
    private int StillTicksToWatch => MaxTicks + LagRecord.NoiseTicks + 1;

    /// <summary>The lag; null if it could not be measured.</summary>
    public PictureLag? Lag { get; private set; }

    /// <summary>Measures until one lag has been found often enough, or too many attempts have failed.</summary>
    /// <param name="isCheckOnly">Whether one measurement within the limit is enough, as for a harvest that does not need the lag.</param>
    /// <exception cref="HarvestFaultException">The lag is greater than the options allow.</exception>
    public IEnumerable<WorkStep> Measure(bool isCheckOnly)
    {
        var votes = new Dictionary<PictureLag, int>();
        int measured = 0;
        for (int attempt = 0; attempt < MaxAttempts && Lag is null; attempt++)
        {
            if (isCheckOnly && measured == 0 && attempt == VainAttemptsOfCheck)
            {
                break;
            }

            var record = new LagRecord();
            yield return WorkStep.Do(Watch(record));

            if (record.LagOf(RunningTicks, MaxTicks) is { } lag)
            {
                measured++;
                votes[lag] = votes.TryGetValue(lag, out int before) ? before + 1 : 1;
                bool isFound = (isCheckOnly && IsAllowed(lag)) || (votes[lag] >= Agreement && 2 * votes[lag] > measured);
                Lag = isFound ? lag : null;
            }
        }

        // Entities that are reported late must be moving again before the first frame.
        for (int tick = 0; tick < RunningTicks; tick++)
        {
            yield return WorkStep.Tick;
        }

        if (Lag is { } found && !IsAllowed(found))
        {
            string atLeast = Counted.Of(Math.Max(found.CameraTicks, found.EntityTicks), "tick") + " or more";
            throw new HarvestFaultException(PictureLag.Refusal(atLeast, "harvest", options.MaxPictureLagTicks));
        }
    }

    private bool IsAllowed(PictureLag lag) => Math.Max(lag.CameraTicks, lag.EntityTicks) <= options.MaxPictureLagTicks;

    private IEnumerable<WorkStep> Watch(LagRecord record)
    {
        // The first images of the record may show any of these states; the game has been running again for only a tick or two since the
        // last freeze.
        for (int tick = 0; tick < MaxTicks + RunningTicks; tick++)
        {
            record.Add(reader.Read());
            yield return WorkStep.Tick;
        }

        PixelBuffer current = pool.Rent();
        PixelBuffer before = pool.Rent();
        var gate = new StillnessGate(_comparison);
        try
        {
            for (
                int tick = 0;
                tick < RunningTicks + options.MaxSettleTicks + StillTicksToWatch && gate.StillTicks < StillTicksToWatch;
                tick++
            )
            {
                if (tick == RunningTicks)
                {
                    game.Pause.Freeze();
                }

                bool good = game.Screen.Grab(current).IsGood;
                double change = PictureDifference.MeanOf(before, current);
                var snapshot = reader.Read();
                record.Add(snapshot, good ? change : double.NaN);
                gate.Observe(snapshot);
                (before, current) = (current, before);
                yield return WorkStep.Tick;
            }
        }
        finally
        {
            game.Pause.Unfreeze();
            pool.Return(before);
            pool.Return(current);
        }
    }
}
