namespace Harvester.Datasets.Validation;

/// <summary>The times of the samples that a sensor gives between frames.</summary>
internal static class SampleTimes
{
    /// <summary>Times closer than this, seconds, are equal: labels have six decimals.</summary>
    private const double TimeTolerance = 1e-6;

    /// <summary>What is wrong with the times, one line each: they ascend, and end with the frame.</summary>
    /// <param name="sensor">The key of the sensor in the label.</param>
    /// <param name="times">The times of the samples, seconds.</param>
    /// <param name="frame">The time of the frame, seconds.</param>
    public static IEnumerable<string> Problems(string sensor, IEnumerable<double> times, double frame)
    {
        double[] all = [.. times];
        for (int i = 0; i < all.Length; i++)
        {
            if (i + 1 < all.Length ? all[i] >= all[i + 1] : all[i] > frame + TimeTolerance)
            {
                yield return FormattableString.Invariant($"sample {i} of {sensor} is not before what follows it.");
            }
        }
    }
}
