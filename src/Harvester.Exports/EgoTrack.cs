using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Exports;

/// <summary>
/// What inertial sensors of the ego vehicle would report. Poses, velocities and controls are the session's; accelerations and rotation
/// rates are differences between neighbouring samples, centred where there is one on both sides.
/// </summary>
internal static class EgoTrack
{
    /// <summary>Samples farther apart than this are not compared, seconds: the game was loaded again, or the car was moved.</summary>
    private const double MaxGapSeconds = 1.5;

    /// <summary>Samples nearer than this are not compared, seconds: their differences are rounding.</summary>
    private const double MinGapSeconds = 1e-4;

    /// <summary>The motion that a label has, with the state at its frame at the end.</summary>
    public static IReadOnlyList<MotionSample> SamplesOf(FrameLabel label)
    {
        Axes axes = label.Ego.Axes ?? Axes.FromHeading(label.Ego.HeadingDegrees);
        return
        [
            .. label.Motion ?? [],
            new MotionSample(label.TimeSeconds, label.Ego.Position, axes.Right, axes.Forward, label.Ego.Velocity, label.Ego.Motion),
        ];
    }

    /// <summary>A vector of the world in the axes of a vehicle: forward, left, up.</summary>
    public static Vector3D InBody(Axes body, Vector3D world)
    {
        Vector3D local = body.ToLocal(world);
        return new Vector3D(local.Y, -local.X, local.Z);
    }

    /// <summary>The readings at consecutive samples.</summary>
    public static IReadOnlyList<EgoReading> Of(IReadOnlyList<MotionSample> samples)
    {
        Pose[] poses = [.. samples.Select(sample => sample.Pose)];
        return [.. samples.Select((sample, index) => ReadingAt(samples, poses, index))];
    }

    private static EgoReading ReadingAt(IReadOnlyList<MotionSample> samples, Pose[] poses, int index)
    {
        MotionSample sample = samples[index];
        int before = index > 0 && IsNear(samples[index - 1], sample) ? index - 1 : index;
        int after = index + 1 < samples.Count && IsNear(sample, samples[index + 1]) ? index + 1 : index;
        Axes body = poses[index].Axes;
        double seconds = samples[after].TimeSeconds - samples[before].TimeSeconds;
        (Vector3D acceleration, Vector3D rate) =
            after > before
                ? (
                    (samples[after].Velocity - samples[before].Velocity) * (1 / seconds),
                    RotationBetween(poses[before].Axes, poses[after].Axes) * (1 / seconds)
                )
                : (body.Forward * (sample.Motion?.Acceleration ?? 0), body.Up * (sample.Motion?.YawRate ?? 0));
        return new EgoReading(
            sample.TimeSeconds,
            poses[index],
            InBody(body, sample.Velocity),
            InBody(body, acceleration),
            InBody(body, rate),
            sample.Motion is { Steering: not null, Throttle: not null, Brake: not null } ? sample.Motion : null
        );
    }

    private static bool IsNear(MotionSample before, MotionSample after) =>
        after.TimeSeconds - before.TimeSeconds is > MinGapSeconds and < MaxGapSeconds;

    /// <summary>The rotation that turns one orientation into another, as a vector along its axis in the world, radians.</summary>
    private static Vector3D RotationBetween(Axes from, Axes to)
    {
        // Half the sum of the cross products of the axes is the sine times the axis; the sum of their products is 1 + 2 times the cosine.
        Vector3D sine = (from.Right.Cross(to.Right) + from.Forward.Cross(to.Forward) + from.Up.Cross(to.Up)) * 0.5;
        double cosine = (from.Right.Dot(to.Right) + from.Forward.Dot(to.Forward) + from.Up.Dot(to.Up) - 1) / 2;
        double length = sine.Length;
        return length < 1e-12 ? sine : sine * (Math.Atan2(length, cosine) / length);
    }
}
