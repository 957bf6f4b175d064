using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Harvesting;

/// <summary>
/// What a satellite receiver at the origin of the ego's model reports: a sample at the first tick of each tenth of a second of the game's
/// time.
/// </summary>
/// <param name="noise">Its noise; null for an ideal receiver.</param>
internal sealed class GnssRecorder(GnssNoise? noise)
{
    /// <summary>Samples per second of game time.</summary>
    public const double RateHz = 10;

    private const double TimeTolerance = 1e-6;

    private readonly GnssErrors? _errors = noise is null ? null : new GnssErrors(noise);
    private readonly Queue<GnssSample> _samples = new();
    private double _tenth = double.NegativeInfinity;
    private double _last = double.NaN;

    /// <summary>Takes the ego at a tick, later than the one before.</summary>
    public void Add(double seconds, EgoState ego)
    {
        double tenth = Math.Floor((seconds + TimeTolerance) * RateHz);
        if (tenth <= _tenth)
        {
            return;
        }

        (Vector3D placeError, Vector3D velocityError) = _errors?.Next(double.IsNaN(_last) ? 0 : seconds - _last) ?? default;
        (_tenth, _last) = (tenth, seconds);
        (double latitude, double longitude, double height) = Wgs84.Of(ego.Pose.Position + placeError);
        if (_samples.Count == MotionRecorder.MaxSamples)
        {
            _samples.Dequeue();
        }

        _samples.Enqueue(new GnssSample(seconds, latitude, longitude, height, ego.Velocity + velocityError));
    }

    /// <summary>Forgets what was taken: a game that was loaded again begins at an earlier time.</summary>
    public void Restart()
    {
        _samples.Clear();
        (_tenth, _last) = (double.NegativeInfinity, double.NaN);
    }

    /// <summary>Takes the samples up to a frame.</summary>
    /// <param name="frameSeconds">Time of the frame.</param>
    public IReadOnlyList<GnssSample> TakeThrough(double frameSeconds)
    {
        var taken = new List<GnssSample>();
        while (_samples.Count > 0 && _samples.Peek().TimeSeconds <= frameSeconds + TimeTolerance)
        {
            taken.Add(_samples.Dequeue());
        }

        return taken;
    }
}
