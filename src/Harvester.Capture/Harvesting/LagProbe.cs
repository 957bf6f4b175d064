using System;
using System.Collections.Generic;
using Harvester.Capture.Imaging;
using Harvester.Capture.Ports;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// Measures by how many ticks the picture is behind the state: it freezes a moving game and watches both. When the state has come to
/// stand at tick s and the picture changes for the last time at tick c, the picture of c is the first of the standing state, and the
/// lag is c - s. A movement too small to be seen makes a single measurement too small, so the greatest must be found several times.
/// </summary>
internal sealed class LagProbe(HarvestOptions options, GamePorts game, SceneReader reader, PixelBufferPool pool)
{
    /// <summary>Ticks watched before the freeze, so that the movement itself is on record.</summary>
    private const int TicksBefore = 2;

    private readonly SceneComparison _comparison = new(options.StillToleranceMetres);

    /// <summary>Whether it is known already that the picture is not later than the options allow; otherwise greater lags are looked for too.</summary>
    public bool IsLagWithinLimit { get; init; }

    private int GreatestTicks => IsLagWithinLimit ? options.MaxPictureLagTicks : HarvestOptions.GreatestPictureLagTicks;

    /// <summary>Long enough to see the latest change that is looked for, and after it the picture's own noise.</summary>
    private int StillTicksToWatch => GreatestTicks + LagRecord.NoiseTicks + 1;

    /// <summary>The lag; null when it could not be measured.</summary>
    public PictureLag? Lag { get; private set; }

    /// <summary>Measures until the greatest lag has been found often enough, or too often in vain.</summary>
    /// <param name="isCheckOnly">Whether one measurement will do, as for a harvest that does not rest on it.</param>
    /// <exception cref="HarvestFaultException">The lag is greater than the options allow for.</exception>
    public IEnumerable<HarvestPhase> Measure(bool isCheckOnly)
    {
        int agreement = isCheckOnly ? 1 : 3;
        int attempts = isCheckOnly ? 2 : 20;
        PictureLag? greatest = null;
        int found = 0;
        for (int attempt = 0; attempt < attempts && found < agreement; attempt++)
        {
            var record = new LagRecord(_comparison);
            foreach (HarvestPhase phase in Watch(record))
            {
                yield return phase;
            }

            if (record.Lag is { } lag)
            {
                bool isGreater = greatest is not { } known || lag.EntityTicks > known.EntityTicks || lag.CameraTicks > known.CameraTicks;
                found = isGreater ? 1 : found + (lag == greatest ? 1 : 0);
                greatest = isGreater ? lag : greatest;
            }

            // The pipeline fills with moving pictures again before the next freeze.
            for (int tick = 0; tick < GreatestTicks + TicksBefore; tick++)
            {
                yield return HarvestPhase.Probing;
            }
        }

        Lag = found >= agreement ? greatest : null;
        if (Lag is { } measured && Math.Max(measured.CameraTicks, measured.EntityTicks) > options.MaxPictureLagTicks)
        {
            string atLeast = FormattableString.Invariant($"{Math.Max(measured.CameraTicks, measured.EntityTicks)} ticks or more");
            throw new HarvestFaultException(PictureLag.Refusal(atLeast, "harvest", options.MaxPictureLagTicks));
        }
    }

    private IEnumerable<HarvestPhase> Watch(LagRecord record)
    {
        PixelBuffer current = pool.Rent();
        PixelBuffer before = pool.Rent();
        var gate = new StillnessGate(_comparison);
        try
        {
            for (int tick = 0; tick < TicksBefore + options.MaxSettleTicks + StillTicksToWatch && gate.StillTicks < StillTicksToWatch; tick++)
            {
                if (tick == TicksBefore)
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
