using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>Records how the ego moves between frames, once in each tick in which the game goes on.</summary>
internal sealed class MotionRecorder(IWorld world)
{
    /// <summary>Samples that are kept when no frame takes them: a minute at 60 ticks per second. The oldest give way.</summary>
    public const int MaxSamples = 3_600;

    /// <summary>Times closer than this, seconds, are equal: labels have six decimals.</summary>
    private const double TimeTolerance = 1e-6;

    private readonly Queue<MotionSample> _samples = new();
    private double _last = double.NegativeInfinity;

    /// <summary>Takes what an inertial unit measures of each recorded tick; null if there is none.</summary>
    public ImuRecorder? Imu { get; init; }

    /// <summary>Records what a satellite receiver reports; null without a receiver.</summary>
    public GnssRecorder? Gnss { get; init; }

    /// <summary>The recorder of a harvest; null if it needs none.</summary>
    public static MotionRecorder? For(HarvestOptions options, IWorld world)
    {
        ImuRecorder? imu = options.Channels.Contains(FrameChannels.Imu.Key) ? new ImuRecorder(options.ImuNoise) : null;
        GnssRecorder? gnss = options.Channels.Contains(FrameChannels.Gnss.Key) ? new GnssRecorder(options.GnssNoise) : null;
        return options.Motion || imu is not null || gnss is not null ? new MotionRecorder(world) { Imu = imu, Gnss = gnss } : null;
    }

    /// <summary>Gives the first of the frames that a flow has taken what was recorded since the frame before.</summary>
    /// <param name="flow">The flow.</param>
    /// <param name="keepsMotion">Whether the motion itself is part of labels, beside the samples of the inertial unit.</param>
    public void GiveTo(ICaptureFlow flow, bool keepsMotion)
    {
        if (flow.TakenSeconds is not { } seconds)
        {
            return;
        }

        // Taken in any case: the frame may be that of another shard.
        IReadOnlyList<MotionSample> samples = TakeBefore(seconds);
        IReadOnlyList<ImuSample>? measured = Imu?.TakeThrough(seconds);
        IReadOnlyList<GnssSample>? located = Gnss?.TakeThrough(seconds);
        if (flow.Taken.Count == 0)
        {
            return;
        }

        flow.Taken[0].Motion = keepsMotion ? samples : null;
        if (measured is not null)
        {
            flow.Taken[0].Add(new ImuPart(measured));
        }

        if (located is not null)
        {
            flow.Taken[0].Add(new GnssPart(located));
        }
    }

    /// <summary>Records the present tick, unless it has been recorded.</summary>
    public void Record()
    {
        double time = world.TimeSeconds;
        if (time <= _last + TimeTolerance)
        {
            // A game that was loaded again begins at an earlier time.
            if (time >= _last - TimeTolerance)
            {
                return;
            }

            _samples.Clear();
            Imu?.Restart();
            Gnss?.Restart();
        }

        EgoState ego = world.ReadEgo();
        _last = time;
        Imu?.Add(time, ego);
        Gnss?.Add(time, ego);
        if (_samples.Count == MaxSamples)
        {
            _samples.Dequeue();
        }

        _samples.Enqueue(MotionSample.Of(time, ego));
    }

    /// <summary>Takes the samples before a frame, whose own state is in its label.</summary>
    /// <param name="frameSeconds">Time of the frame.</param>
    public IReadOnlyList<MotionSample> TakeBefore(double frameSeconds)
    {
        var taken = new List<MotionSample>();
        while (_samples.Count > 0 && _samples.Peek().TimeSeconds <= frameSeconds + TimeTolerance)
        {
            MotionSample sample = _samples.Dequeue();
            if (sample.TimeSeconds < frameSeconds - TimeTolerance)
            {
                taken.Add(sample);
            }
        }

        _last = System.Math.Max(_last, frameSeconds);
        return taken;
    }
}
