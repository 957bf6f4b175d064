using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// A pedestrian who walks up and down a pavement and sometimes crosses the street at its end, when no vehicle comes; or stands there, or
/// sits on a bench.
/// </summary>
internal sealed class Walker : IPerson
{
    /// <summary>
    /// At the end of a pavement with a street ahead, a pedestrian who cannot cross turns back with this probability in each span of this
    /// time, seconds: after 6 s on average.
    /// </summary>
    private const double TurnSeconds = 0.6;
    private const double TurnProbability = 0.1;

    /// <summary>Distance of the pedestrians' lines from the kerb, metres: from the first on, over a width of the second.</summary>
    private const double MinBeyondKerb = 0.4;
    private const double WidthBeyondKerb = 2.2;

    /// <summary>Shares of those who do not walk: on a usual street, some wait and a few rest.</summary>
    private const double StandingShare = 0.16;
    private const double SittingShare = 0.1;

    /// <summary>A pedestrian walks at the usual pace of the model, or up to this much slower or faster.</summary>
    private const double PaceSpread = 0.08;

    private readonly Random _random;
    private readonly Activity _activity;
    private readonly double _facing;
    private readonly int _rest;
    private readonly double _beyondKerb;
    private Walkway _walkway;
    private Walkway? _opposite;
    private double _distance;
    private double _crossed;
    private int _direction;
    private Skeleton? _skeleton;
    private ThrownPerson? _thrown;

    public Walker(int handle, Model model, int seed, Walkway walkway)
    {
        Handle = handle;
        Model = model;
        _random = new Random(seed);
        _walkway = walkway;
        _distance = walkway.From + (_random.NextDouble() * walkway.Length);
        _direction = _random.Next(2) == 0 ? 1 : -1;
        _beyondKerb = MinBeyondKerb + (WidthBeyondKerb * _random.NextDouble());
        WalkingSpeed = model.Pace * (1 + (PaceSpread * ((2 * _random.NextDouble()) - 1)));
        Walked = model.StrideMetres * _random.NextDouble();
        double activity = _random.NextDouble();
        _activity =
            activity < SittingShare ? Activity.Sitting
            : activity < SittingShare + StandingShare ? Activity.Standing
            : Activity.Walking;
        IsMoving = _activity == Activity.Walking;
        _facing = 2 * Math.PI * _random.NextDouble();
        _rest =
            _activity == Activity.Sitting
                ? PersonPoses.FirstSitting + _random.Next(PersonPoses.SittingCount)
                : PersonPoses.FirstStanding + _random.Next(PersonPoses.StandingCount);
        _beyondKerb = _activity == Activity.Sitting ? Walkway.Width - StreetModels.BenchDepth : _beyondKerb;
        Place();
    }

    public int Handle { get; }

    public Model Model { get; }

    public double WalkingSpeed { get; }

    /// <summary>Metres walked, which select the phase of the stride.</summary>
    public double Walked { get; private set; }

    /// <summary>The mesh of the current posture.</summary>
    public Mesh Look => Model.Variants[Posture];

    /// <summary>The joints of the current posture, metres, world.</summary>
    public Skeleton Skeleton => _skeleton ??= Model.Skeletons[Posture].MovedBy(Pose);

    /// <summary>The bench, on which only this pedestrian sits; null for someone who does not sit.</summary>
    public Pose? Bench =>
        _activity == Activity.Sitting ? Pose with { Position = Pose.ToWorld(new Vector3D(0, -Rest.SeatBehind, Model.Min.Z)) } : null;

    public bool IsMoving { get; private set; }

    public bool IsOnRoad => _opposite is not null || IsThrown;

    public bool IsThrown => _thrown is not null;

    public Pose Pose { get; private set; }

    private int Posture => IsMoving ? (int)(Walked / Model.StrideMetres * PersonPoses.Phases) % PersonPoses.Phases : _rest;

    public Footprint Footprint => _thrown?.Footprint ?? Footprint.Of(Pose, Model.Min, Model.Max);

    /// <summary>
    /// Along the pavement, up and down its slope and longer on the outside of a bend; horizontal where the street is crossed.
    /// </summary>
    public Vector3D Velocity =>
        _thrown is { } thrown ? thrown.Velocity
        : !IsMoving ? Vector3D.Zero
        : _opposite is null ? _walkway.TangentBeyondKerb(_distance, _beyondKerb) * (_direction * WalkingSpeed)
        : Pose.Axes.Forward * WalkingSpeed;

    /// <summary>
    /// Walks on, given functions for the pavement across the street at a position, and for whether no vehicle comes near a position.
    /// </summary>
    public void Tick(double seconds, Func<Walkway, double, Walkway?> oppositeOf, Func<Vector3D, bool> isSafe)
    {
        if (_thrown is { } thrown)
        {
            thrown.Tick(seconds);
            Pose = thrown.Pose;
            _skeleton = null;
            return;
        }

        if (_activity != Activity.Walking)
        {
            return;
        }

        double metres = WalkingSpeed * seconds;
        IsMoving = true;
        if (_opposite is not null)
        {
            Cross(metres);
        }
        else if (!Along(metres))
        {
            AtEnd(seconds, oppositeOf(_walkway, _distance), isSafe);
        }

        Walked += IsMoving ? metres : 0;
        Place();
    }

    public void Throw(Vector3D clear, Vector2D velocity, Func<Vector3D, double, double> groundAt)
    {
        _thrown = new ThrownPerson(Model, Pose with { Position = Pose.Position + clear }, velocity, groundAt);
        Pose = _thrown.Pose;
        _skeleton = null;
    }

    private bool Along(double metres)
    {
        double next = _distance + (_direction * metres);
        bool isWithin = next > _walkway.From && next < _walkway.To;
        _distance = isWithin ? next : _distance;
        return isWithin;
    }

    private void AtEnd(double seconds, Walkway? opposite, Func<Vector3D, bool> isSafe)
    {
        IsMoving = false;
        if (opposite is not null && isSafe(_walkway.Road.Curve.PositionAt(_distance)))
        {
            _opposite = opposite;
            _crossed = 0;
        }
        else if (opposite is null || _random.NextDouble() < seconds / TurnSeconds * TurnProbability)
        {
            _direction = -_direction;
        }
    }

    private void Cross(double metres)
    {
        _crossed += metres;
        if (_crossed >= CrossingLength)
        {
            _walkway = _opposite!;
            _distance = Math.Clamp(_distance, _walkway.From, _walkway.To);
            _direction = -_direction;
            _opposite = null;
        }
    }

    private double CrossingLength => _walkway.Road.RightKerb - _walkway.Road.LeftKerb + (2 * _beyondKerb);

    private void Place()
    {
        Vector3D along = _walkway.Road.Curve.TangentAt(_distance);
        Vector3D level = new Vector3D(along.X, along.Y, 0).Normalized();
        Vector3D forward = level * _direction;
        Vector3D feet = _walkway.PlaceBeyondKerb(_distance, _beyondKerb);
        if (_opposite is not null)
        {
            Vector3D across = Horizontal.RightOf(level) * -_walkway.Side;
            bool isOnPavement = _crossed < _beyondKerb || _crossed > CrossingLength - _beyondKerb;
            feet += (across * _crossed) - (Horizontal.Up * (isOnPavement ? 0 : Walkway.KerbHeight));
            forward = across;
        }

        if (_activity == Activity.Sitting)
        {
            forward = Horizontal.RightOf(level) * -_walkway.Side;
        }
        else if (_activity == Activity.Standing)
        {
            forward = (level * Math.Cos(_facing)) + (Horizontal.RightOf(level) * Math.Sin(_facing));
        }

        Pose = new Pose(feet - (Horizontal.Up * Model.Min.Z), Horizontal.AxesAlong(forward));
        _skeleton = null;
    }
}
