using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the samples of the satellite receiver: their times ascend and end with the frame, and they are places on Earth.
/// </summary>
internal static class GnssCheck
{
    /// <summary>Times closer than this, seconds, are equal: labels have six decimals.</summary>
    private const double TimeTolerance = 1e-6;

    private const double MaxLatitude = 90;
    private const double MaxLongitude = 180;

    public static IEnumerable<string> Problems(FrameLabel label)
    {
        IReadOnlyList<GnssSample> samples = label.Channels.Get<GnssLabel>()?.Samples ?? [];
        for (int i = 0; i < samples.Count; i++)
        {
            bool isLate =
                i + 1 < samples.Count
                    ? samples[i].TimeSeconds >= samples[i + 1].TimeSeconds
                    : samples[i].TimeSeconds > label.TimeSeconds + TimeTolerance;
            if (isLate)
            {
                yield return FormattableString.Invariant($"sample {i} of gnss is not before what follows it.");
            }

            if (Math.Abs(samples[i].LatitudeDegrees) > MaxLatitude || Math.Abs(samples[i].LongitudeDegrees) > MaxLongitude)
            {
                yield return FormattableString.Invariant($"sample {i} of gnss is no place on Earth.");
            }
        }
    }
}
