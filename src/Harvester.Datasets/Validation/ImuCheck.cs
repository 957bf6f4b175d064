using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the samples of the inertial unit: their times ascend and end with the frame, and they are within what a unit measures.
/// </summary>
internal static class ImuCheck
{
    /// <summary>Maximum rate, rad/s: two attitudes a 60th of a second apart show at most half a turn, 188 rad/s.</summary>
    private const double MaxRate = 200;

    /// <summary>No vehicle is hit harder, m/s²: a change of 100 m/s in a 60th of a second.</summary>
    private const double MaxForce = 6000;

    public static IEnumerable<string> Problems(FrameLabel label)
    {
        IReadOnlyList<ImuSample> samples = label.Channels.Get<ImuLabel>()?.Samples ?? [];
        foreach (string problem in SampleTimes.Problems("imu", samples.Select(static sample => sample.TimeSeconds), label.TimeSeconds))
        {
            yield return problem;
        }

        for (int i = 0; i < samples.Count; i++)
        {
            if (samples[i].AngularRate.Length > MaxRate || samples[i].SpecificForce.Length > MaxForce)
            {
                yield return FormattableString.Invariant($"sample {i} of imu is more than a vehicle can do.");
            }
        }
    }
}
