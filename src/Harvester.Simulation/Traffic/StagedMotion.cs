using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>How a staged actor moves: along a path, at a speed that approaches the one ordered.</summary>
internal sealed class StagedMotion
{
    /// <summary>Deceleration before the end of a path and before bodies ahead, m/s²; in need up to the second one.</summary>
    public const double StoppingDeceleration = 3;
    private const double HardestBraking = 8;

    /// <summary>Acceleration after a change that is over, m/s².</summary>
    private const double ResumingAcceleration = 2;

    private StagedWay? _way;
    private double _wanted;
    private double _acceleration = 1;
    private bool _isBackwards;
    private double _secondsToResume = double.PositiveInfinity;
    private double _resumed;

    /// <summary>An actor that rolls straight on from a place.</summary>
    /// <param name="ground">Where it is, on the ground, metres, world.</param>
    /// <param name="forward">Horizontal unit direction in which it looks.</param>
    /// <param name="speed">Metres per second.</param>
    public StagedMotion(Vector3D ground, Vector3D forward, double speed)
    {
        (Ground, Forward, Speed, _wanted) = (ground, forward, speed, speed);
    }

    /// <summary>Where it is, on the ground, metres, world.</summary>
    public Vector3D Ground { get; private set; }

    /// <summary>Horizontal unit direction in which it looks.</summary>
    public Vector3D Forward { get; private set; }

    /// <summary>Metres per second along its path; 0 or more.</summary>
    public double Speed { get; private set; }

    /// <summary>Metres from the start of its path; without one, those since it was put there.</summary>
    public double Along { get; private set; }

    /// <summary>Whether it is on no path, or at its end.</summary>
    public bool IsAtEnd => _way is null || Along >= _way.Length;

    /// <summary>Whether it drives on whatever stands in its way.</summary>
    public bool IgnoresOthers { get; private set; }

    /// <summary>Whether an intervention has taken it out of the hands of whoever staged it, whose orders it then no longer takes.</summary>
    public bool IsChanged { get; private set; }

    /// <summary>Horizontal velocity, metres per second.</summary>
    public Vector3D Velocity => Forward * (_isBackwards ? -Speed : Speed);

    /// <summary>Takes a path, from the point nearest to it on.</summary>
    public void Follow(StagedWay way, double speed, double acceleration, bool isBackwards, bool ignoresOthers)
    {
        (_way, _isBackwards, IgnoresOthers) = (way, isBackwards, ignoresOthers);
        Along = way.Nearest(Ground);
        SetSpeed(speed, acceleration);
    }

    public void SetSpeed(double speed, double acceleration) => (_wanted, _acceleration) = (speed, acceleration);

    /// <summary>Lets it go on along its path at another speed, without regard to later orders.</summary>
    /// <param name="speed">Metres per second.</param>
    /// <param name="acceleration">By how much its speed changes at most, m/s².</param>
    /// <param name="seconds">Time after which it takes the speed that was ordered before; null for never.</param>
    public void Change(double speed, double acceleration, double? seconds)
    {
        // Of several changes, what was ordered before the first one is meant.
        _resumed = IsChanged ? _resumed : _wanted;
        _secondsToResume = seconds ?? double.PositiveInfinity;
        IsChanged = true;
        SetSpeed(speed, acceleration);
    }

    /// <summary>Lets the time of a change pass.</summary>
    public void Pass(double seconds)
    {
        _secondsToResume -= seconds;
        if (_secondsToResume <= 0)
        {
            _secondsToResume = double.PositiveInfinity;
            SetSpeed(_resumed, ResumingAcceleration);
        }
    }

    /// <summary>Stops it at once, as where it meets a body; it moves on if that goes.</summary>
    public void Stop() => Speed = 0;

    /// <summary>Takes the motion of a body that something else has moved, such as a collision.</summary>
    /// <param name="ground">Where it is now.</param>
    /// <param name="forward">Where it looks.</param>
    /// <param name="speed">Its speed.</param>
    public void Displace(Vector3D ground, Vector3D forward, double speed)
    {
        (Ground, Forward, Speed) = (ground, forward, speed);
        _way = null;
        _wanted = 0;
        _secondsToResume = double.PositiveInfinity;
    }

    /// <summary>Where it would be after a time step, and with which speed.</summary>
    /// <param name="seconds">The time step.</param>
    /// <param name="most">Greatest speed that what is ahead allows, m/s.</param>
    public StagedStep After(double seconds, double most = double.PositiveInfinity)
    {
        // The speed approaches the wanted one at the ordered rate. What is ahead, or the end of the path, may limit it further, such that
        // an even deceleration of StoppingDeceleration ends there: v² = 2 a way.
        double left = _way is null ? double.PositiveInfinity : Math.Max(0, _way.Length - Along);
        double limit = Math.Min(most, Math.Sqrt(2 * StoppingDeceleration * left));
        double slowest = (limit < _wanted ? Math.Max(_acceleration, HardestBraking) : _acceleration) * seconds;
        double speed = Math.Max(0, Speed + Math.Clamp(Math.Min(_wanted, limit) - Speed, -slowest, _acceleration * seconds));
        double metres = (Speed + speed) / 2 * seconds;
        if (_way is null)
        {
            return new StagedStep(Ground + (Forward * metres), Forward, Along + metres, speed);
        }

        double along = Math.Min(Along + metres, _way.Length);
        Vector3D direction = _way.DirectionAt(along);
        return new StagedStep(_way.PositionAt(along), _isBackwards ? -direction : direction, along, along >= _way.Length ? 0 : speed);
    }

    /// <summary>Makes a step.</summary>
    public void Take(StagedStep step) => (Ground, Forward, Along, Speed) = (step.Ground, step.Forward, step.Along, step.Speed);

    /// <summary>The place and the direction at a distance ahead of it, metres along its path.</summary>
    public StagedStep Ahead(double metres)
    {
        if (_way is null)
        {
            return new StagedStep(
                Ground + (Velocity.LengthSquared > 0 ? Velocity.Normalized() * metres : Forward * metres),
                Forward,
                Along + metres,
                Speed
            );
        }

        Vector3D direction = _way.DirectionAt(Along + metres);
        return new StagedStep(_way.PositionAt(Along + metres), _isBackwards ? -direction : direction, Along + metres, Speed);
    }

    /// <summary>Puts it at the height of the ground there.</summary>
    public void Stand(double height) => Ground = Ground with { Z = height };
}
