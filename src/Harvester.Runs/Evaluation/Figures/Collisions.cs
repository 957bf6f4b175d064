namespace Harvester.Runs.Evaluation.Figures;

/// <summary>Finds collisions: the first sample of each contact with a vehicle.</summary>
public static class Collisions
{
    /// <summary>Indices of the samples, one for each vehicle touched.</summary>
    public static IEnumerable<int> In(IReadOnlyList<DriveSample> samples)
    {
        ArgumentNullException.ThrowIfNull(samples);
        IReadOnlyList<int> before = [];
        for (int i = 0; i < samples.Count; i++)
        {
            foreach (int _ in samples[i].Touching.Except(before))
            {
                yield return i;
            }

            before = samples[i].Touching;
        }
    }
}
