using Harvester.Geometry;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>A person who was struck by a vehicle: flies, falls, slides and lies, head away from the vehicle.</summary>
internal sealed class ThrownPerson
{
    private readonly Model _model;
    private readonly Axes _upright;
    private readonly Vector3D _from;
    private readonly Vector3D _along;
    private readonly Vector3D _half;
    private readonly Func<Vector3D, double, double> _groundAt;
    private readonly PersonThrow _throw;
    private double _ground;
    private double _seconds;

    /// <param name="model">The person's model.</param>
    /// <param name="pose">The pose when struck, clear of the vehicle.</param>
    /// <param name="velocity">Velocity after the impact, m/s, world x and y.</param>
    /// <param name="groundAt">Height of the ground at a place, or the given height where it is unknown.</param>
    public ThrownPerson(Model model, Pose pose, Vector2D velocity, Func<Vector3D, double, double> groundAt)
    {
        _model = model;
        _upright = pose.Axes;
        _groundAt = groundAt;
        _from = pose.ToWorld((model.Min + model.Max) * 0.5);
        _half = (model.Max - model.Min) * 0.5;
        _ground = _from.Z - _half.Z;
        double speed = velocity.Length;
        _along = speed > 0 ? new Vector3D(velocity.X / speed, velocity.Y / speed, 0) : Horizontal.RightOf(pose.Axes.Forward);
        _throw = new PersonThrow(speed, _half.Z - Reach(Turned(Math.PI / 2), Horizontal.Up));
        Place();
    }

    public Pose Pose { get; private set; }

    public Footprint Footprint { get; private set; }

    public Vector3D Velocity { get; private set; }

    public bool IsAtRest => _seconds >= _throw.TotalSeconds;

    public void Tick(double seconds)
    {
        if (!IsAtRest)
        {
            _seconds = Math.Min(_seconds + seconds, _throw.TotalSeconds);
            Place();
        }
    }

    private void Place()
    {
        Vector3D before = Pose.Position;
        Axes axes = Turned(Math.PI / 2 * Math.Min(1, _seconds / _throw.FlightSeconds));
        Vector3D place = _from + (_along * _throw.MetresAt(_seconds));
        _ground = _groundAt(place with { Z = _ground }, _ground);
        double above = Math.Max(Reach(axes, Horizontal.Up), _half.Z - _throw.FallenAt(_seconds));
        Vector3D middle = place with { Z = _ground + above };
        Pose = new Pose(middle - axes.ToWorld((_model.Min + _model.Max) * 0.5), axes);
        Footprint = new Footprint(middle, _along, Reach(axes, _along), Reach(axes, Horizontal.RightOf(_along)));
        Velocity = IsAtRest ? Vector3D.Zero : _along * _throw.SpeedAt(_seconds);
    }

    /// <summary>How far the box reaches along a direction, from its middle, metres.</summary>
    private double Reach(Axes axes, Vector3D direction) =>
        (Math.Abs(axes.Right.Dot(direction)) * _half.X)
        + (Math.Abs(axes.Forward.Dot(direction)) * _half.Y)
        + (Math.Abs(axes.Up.Dot(direction)) * _half.Z);

    /// <summary>The orientation after a fall by an angle, radians, in which the head goes along the throw.</summary>
    private Axes Turned(double angle)
    {
        // Rodrigues: v cos a + (k × v) sin a + k (k · v) (1 - cos a), about k = up × direction of the throw.
        Vector3D axis = Horizontal.Up.Cross(_along);
        Vector3D right = Turned(_upright.Right).Normalized();
        Vector3D up = Turned(_upright.Up);
        Vector3D forward = up.Cross(right).Normalized();
        return Axes.FromVectors(right, forward, right.Cross(forward));

        Vector3D Turned(Vector3D vector) =>
            (vector * Math.Cos(angle)) + (axis.Cross(vector) * Math.Sin(angle)) + (axis * (axis.Dot(vector) * (1 - Math.Cos(angle))));
    }
}
