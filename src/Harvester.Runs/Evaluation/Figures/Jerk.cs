namespace Harvester.Runs.Evaluation.Figures;

/// <summary>The longitudinal jerk of a controller: the second difference of the speed, m/s³.</summary>
public static class Jerk
{
    /// <summary>The jerk at each sample up to which the controller drove, with the index of the sample.</summary>
    public static IEnumerable<(int Sample, double Jerk)> Of(IReadOnlyList<DriveSample> samples)
    {
        ArgumentNullException.ThrowIfNull(samples);
        for (int i = 2; i < samples.Count; i++)
        {
            if (
                samples[i].IsTeleported
                || samples[i - 1].IsTeleported
                || !(samples[i].IsByController && samples[i - 1].IsByController && samples[i - 2].IsByController)
            )
            {
                continue;
            }

            double step = samples[i].TimeSeconds - samples[i - 1].TimeSeconds;
            yield return (i, (samples[i].Speed - (2 * samples[i - 1].Speed) + samples[i - 2].Speed) / (step * step));
        }
    }
}
