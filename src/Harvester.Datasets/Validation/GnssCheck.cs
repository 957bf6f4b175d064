using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the samples of the satellite receiver: their times ascend and end with the frame, and they are places on Earth.
/// </summary>
internal static class GnssCheck
{
    private const double MaxLatitude = 90;
    private const double MaxLongitude = 180;

    public static IEnumerable<string> Problems(FrameLabel label)
    {
        IReadOnlyList<GnssSample> samples = label.Channels.Get<GnssLabel>()?.Samples ?? [];
        foreach (string problem in SampleTimes.Problems("gnss", samples.Select(static sample => sample.TimeSeconds), label.TimeSeconds))
        {
            yield return problem;
        }

        for (int i = 0; i < samples.Count; i++)
        {
            if (Math.Abs(samples[i].LatitudeDegrees) > MaxLatitude || Math.Abs(samples[i].LongitudeDegrees) > MaxLongitude)
            {
                yield return FormattableString.Invariant($"sample {i} of gnss is no place on Earth.");
            }
        }
    }
}
