using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the motion between frames: its times ascend and end before the frame, and controls are in their ranges.</summary>
internal static class MotionCheck
{
    public static IEnumerable<string> Problems(FrameLabel label)
    {
        IReadOnlyList<MotionSample> samples = label.Motion ?? [];
        for (int i = 0; i < samples.Count; i++)
        {
            double next = i + 1 < samples.Count ? samples[i + 1].TimeSeconds : label.TimeSeconds;
            if (samples[i].TimeSeconds >= next)
            {
                yield return FormattableString.Invariant($"motion[{i}] is not before what follows it.");
            }

            if (samples[i].Motion is { Steering: < -1 or > 1 } or { Throttle: < 0 or > 1 } or { Brake: < 0 or > 1 })
            {
                yield return FormattableString.Invariant($"motion[{i}] has a control outside its range.");
            }
        }
    }
}
