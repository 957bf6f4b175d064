using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Motion;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// What an inertial unit at the origin of the ego's model measures: a sample for each tick, the mean from the tick before. A tick in
/// which the vehicle is replaced or teleported has no sample.
/// </summary>
/// <param name="noise">Its noise; null for an ideal unit.</param>
internal sealed class ImuRecorder(ImuNoise? noise)
{
    /// <summary>Between readings farther apart, seconds, the motion is not known.</summary>
    public const double MaxSeconds = 0.25;

    /// <summary>A vehicle this far from where its velocities lead was put there, metres.</summary>
    public const double JumpMetres = 0.5;

    private const double TimeTolerance = 1e-6;

    private readonly ImuErrors? _errors = noise is null ? null : new ImuErrors(noise);
    private readonly Queue<ImuSample> _samples = new();
    private (double Seconds, EgoState Ego)? _before;

    /// <summary>Takes the ego at a tick, later than the one before.</summary>
    public void Add(double seconds, EgoState ego)
    {
        if (_before is { } before && IsContinued(before.Seconds, before.Ego, seconds, ego))
        {
            double interval = seconds - before.Seconds;
            Vector3D rotation = InertialMotion.Rotation(before.Ego.Pose.Axes, ego.Pose.Axes);
            Vector3D force = InertialMotion.SpecificForce(before.Ego.Pose.Axes, rotation, ego.Velocity - before.Ego.Velocity, interval);
            (Vector3D rateError, Vector3D forceError) = _errors?.Next(interval) ?? default;
            if (_samples.Count == MotionRecorder.MaxSamples)
            {
                _samples.Dequeue();
            }

            _samples.Enqueue(new ImuSample(seconds, (rotation / interval) + rateError, force + forceError));
        }

        _before = (seconds, ego);
    }

    /// <summary>Forgets what was taken: a game that was loaded again begins at an earlier time.</summary>
    public void Restart()
    {
        _samples.Clear();
        _before = null;
    }

    /// <summary>Takes the samples up to a frame.</summary>
    /// <param name="frameSeconds">Time of the frame.</param>
    public IReadOnlyList<ImuSample> TakeThrough(double frameSeconds)
    {
        var taken = new List<ImuSample>();
        while (_samples.Count > 0 && _samples.Peek().TimeSeconds <= frameSeconds + TimeTolerance)
        {
            taken.Add(_samples.Dequeue());
        }

        return taken;
    }

    private static bool IsContinued(double earlier, EgoState before, double later, EgoState now)
    {
        double interval = later - earlier;
        Vector3D led = (before.Velocity + now.Velocity) * (interval / 2);
        return before.Handle == now.Handle
            && interval is > TimeTolerance and <= MaxSeconds
            && (now.Pose.Position - before.Pose.Position - led).Length <= JumpMetres;
    }
}
