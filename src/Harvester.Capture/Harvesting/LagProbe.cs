using System;
using System.Collections.Generic;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Measures by how many ticks the picture is behind the state: it freezes a moving game, watches both, and finds the shift by which the
/// changes of the picture follow the movement (<see cref="LagRecord"/>). What a single freeze shows may deceive, as where the world creeps
/// on by less than a picture shows, so the same lag must be found several times, and more often than all others.
/// </summary>
internal sealed class LagProbe(HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool)
{
    /// <summary>Changes of the picture that are watched before the freeze, so that the movement itself is on record.</summary>
    private const int RunningTicks = 4;

    private const int Agreement = 3;
    private const int MaxAttempts = 20;

    /// <summary>After so many attempts in vain a harvest that does not rest on the lag goes on without it.</summary>
    private const int VainAttemptsOfCheck = 2;

    private readonly SceneComparison _comparison = new(options.StillToleranceMetres);

    /// <summary>
    /// Whether it is known already that the picture is not later than the options allow; otherwise greater lags are looked for too.
    /// </summary>
    public bool IsLagWithinLimit { get; init; }

    private int GreatestTicks => IsLagWithinLimit ? options.MaxPictureLagTicks : PictureLag.MaxTicks;

    /// <summary>Long enough to see the latest change that is looked for, and after it the picture's own noise.</summary>
    private int StillTicksToWatch => GreatestTicks + LagRecord.NoiseTicks + 1;

    /// <summary>The lag; null when it could not be measured.</summary>
    public PictureLag? Lag { get; private set; }

    /// <summary>Measures until one lag has been found often enough, or too often in vain.</summary>
    /// <param name="isCheckOnly">Whether one measurement within the limit will do, as for a harvest that does not rest on it.</param>
    /// <exception cref="HarvestFaultException">The lag is greater than the options allow for.</exception>
    public IEnumerable<HarvestPhase> Measure(bool isCheckOnly)
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
            foreach (HarvestPhase phase in Watch(record))
            {
                yield return phase;
            }

            if (record.LagOf(RunningTicks, GreatestTicks) is { } lag)
            {
                measured++;
                votes[lag] = votes.TryGetValue(lag, out int before) ? before + 1 : 1;
                bool isFound = (isCheckOnly && IsAllowed(lag)) || (votes[lag] >= Agreement && 2 * votes[lag] > measured);
                Lag = isFound ? lag : null;
            }
        }

        // What is reported late must be moving again before the first frame.
        for (int tick = 0; tick < RunningTicks; tick++)
        {
            yield return HarvestPhase.Probing;
        }

        if (Lag is { } found && !IsAllowed(found))
        {
            string atLeast = FormattableString.Invariant($"{Math.Max(found.CameraTicks, found.EntityTicks)} ticks or more");
            throw new HarvestFaultException(PictureLag.Refusal(atLeast, "harvest", options.MaxPictureLagTicks));
        }
    }

    private bool IsAllowed(PictureLag lag) => Math.Max(lag.CameraTicks, lag.EntityTicks) <= options.MaxPictureLagTicks;

    private IEnumerable<HarvestPhase> Watch(LagRecord record)
    {
        // The first pictures of the record may show any of these states; only since a tick or two does the game run again after the last
        // freeze.
        for (int tick = 0; tick < GreatestTicks + RunningTicks; tick++)
        {
            record.Add(reader.Read());
            yield return HarvestPhase.Probing;
        }

        PixelBuffer current = pool.Rent();
        PixelBuffer before = pool.Rent();
        var gate = new StillnessGate(_comparison);
        try
        {
            for (int tick = 0; tick < RunningTicks + options.MaxSettleTicks + StillTicksToWatch
                && gate.StillTicks < StillTicksToWatch; tick++)
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
                yield return HarvestPhase.Probing;
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
