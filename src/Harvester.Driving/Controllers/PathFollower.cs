using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Controllers;

/// <summary>
/// Drives a car along a path of points by pure pursuit (Coulter, Implementation of the Pure Pursuit Path Tracking Algorithm,
/// CMU-RI-TR-92-01): it steers along the arc to a point of the path ahead, slows down in bends and stops behind what stands in the way.
/// </summary>
public sealed class PathFollower
{
    /// <summary>The path is driven when less than this is left of it, metres.</summary>
    private const double ReachedMetres = 3;

    /// <summary>The point steered to is this far ahead at least, metres, and otherwise where the car is after this time, seconds.</summary>
    private const double MinAheadMetres = 5;
    private const double AheadSeconds = 0.8;

    /// <summary>Length of the path in which the nearest point is looked for, metres.</summary>
    private const double SearchMetres = 30;

    /// <summary>Acceleration across the car that bends may cause, m/s².</summary>
    private const double MaxAcross = 3;

    /// <summary>Deceleration before obstacles, m/s².</summary>
    private const double Braking = 3;

    /// <summary>Acceleration per missing speed, 1/s.</summary>
    private const double SpeedGain = 1;

    /// <summary>Half the width of the way that must be free, metres: that of a wide car and some room.</summary>
    private const double HalfWidth = 1.6;

    /// <summary>Distance at which it stops before an obstacle, metres from its middle.</summary>
    private const double StandOff = 3;

    /// <summary>Minimum curvature by which the speed in bends is divided, 1/m; it limits no speed.</summary>
    private const double MinBend = 1e-6;
    private readonly CarTraits _car = new();
    private readonly Vector2D[] _points;
    private readonly double[] _distances;
    private readonly double _speed;
    private double _along;

    /// <summary>A follower at the beginning of a path.</summary>
    /// <param name="path">At least two points, metres, world, each unlike the one before.</param>
    /// <param name="speedMetresPerSecond">The speed to drive where nothing is in the way, m/s.</param>
    /// <exception cref="ArgumentException">The path has fewer than two points.</exception>
    public PathFollower(IReadOnlyList<Vector2D> path, double speedMetresPerSecond)
    {
        _points = [.. path];
        if (_points.Length < 2)
        {
            throw new ArgumentException("A path has at least two points.", nameof(path));
        }

        _speed = speedMetresPerSecond;
        _distances = new double[_points.Length];
        for (int i = 1; i < _points.Length; i++)
        {
            _distances[i] = _distances[i - 1] + (_points[i] - _points[i - 1]).Length;
        }
    }

    /// <summary>The direction of the path at its beginning, degrees counter-clockwise from north.</summary>
    public double StartHeadingDegrees => HeadingOf(_points[1] - _points[0]);

    /// <summary>Whether the car has come to the end of the path.</summary>
    public bool IsAtEnd => _along >= _distances[_distances.Length - 1] - ReachedMetres;

    /// <summary>Distance of the car from the path at the last call, metres.</summary>
    public double OffMetres { get; private set; }

    /// <summary>The direction of a displacement, degrees counter-clockwise from north.</summary>
    public static double HeadingOf(Vector2D displacement) => Math.Atan2(-displacement.X, displacement.Y) * 180 / Math.PI;

    /// <summary>The controls for the coming tick.</summary>
    /// <param name="ego">The car.</param>
    /// <param name="near">The objects around it.</param>
    public DrivingControls Drive(EgoState ego, IEnumerable<EntityState> near)
    {
        Pose pose = (ego ?? throw new ArgumentNullException(nameof(ego))).Pose;
        var place = new Vector2D(pose.Position.X, pose.Position.Y);
        Advance(place);
        double speed = ego.Velocity.Dot(pose.Axes.Forward);
        double ahead = Math.Max(MinAheadMetres, AheadSeconds * speed);
        Vector2D target = At(_along + ahead) - place;
        double forward = target.Dot(new Vector2D(pose.Axes.Forward.X, pose.Axes.Forward.Y));
        double left = -target.Dot(new Vector2D(pose.Axes.Right.X, pose.Axes.Right.Y));

        // Pure pursuit: the circle through the car, along its heading, and the target has the curvature 2 · left / distance².
        double curvature = 2 * left / Math.Max(1, target.Dot(target));
        double wheel =
            forward < 0 ? Math.Sign(left) * _car.SteeringLockRadians : Math.Atan(_car.Wheelbase * curvature * _car.UndersteerAt(speed));

        // v² κ ≤ MaxAcross.
        double wanted = Math.Min(_speed, Math.Sqrt(MaxAcross / Math.Max(MinBend, Math.Abs(curvature))));
        wanted = Math.Min(wanted, SpeedBefore(FreeMetres(pose, near)));
        double acceleration = SpeedGain * (wanted - speed);
        return new DrivingControls(
            wheel / _car.SteeringLockRadians,
            acceleration / _car.FullThrottle,
            wanted < speed ? -acceleration / Braking : 0
        );
    }

    // v² = 2 · braking · way.
    private static double SpeedBefore(double metres) => Math.Sqrt(2 * Braking * Math.Max(0, metres - StandOff));

    /// <summary>How far the way straight ahead is free, metres from the car's middle.</summary>
    private static double FreeMetres(Pose pose, IEnumerable<EntityState> near) =>
        near.Where(entity => entity.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Other))
            .Select(entity => (entity, to: entity.Pose.Position - pose.Position))
            .Select(each =>
                (
                    ahead: each.to.Dot(pose.Axes.Forward),
                    across: Math.Abs(each.to.Dot(pose.Axes.Right)),
                    half: (each.entity.ModelMax - each.entity.ModelMin) * 0.5
                )
            )
            .Where(each => each.ahead > 0 && each.across < HalfWidth + each.half.X)
            .Select(each => each.ahead - each.half.Y)
            .DefaultIfEmpty(double.PositiveInfinity)
            .Min();

    /// <summary>Goes on to the nearest point of the path, neither behind the last one nor so far ahead that it is another bend.</summary>
    private void Advance(Vector2D place)
    {
        double best = double.PositiveInfinity;
        double along = _along;
        for (int i = Math.Max(0, SegmentAt(_along)); i < _points.Length - 1 && _distances[i] < _along + SearchMetres; i++)
        {
            Vector2D step = _points[i + 1] - _points[i];
            double fraction = Math.Max(0, Math.Min(1, (place - _points[i]).Dot(step) / step.Dot(step)));
            double off = (place - (_points[i] + (step * fraction))).Length;
            if (off < best)
            {
                (best, along) = (off, _distances[i] + (fraction * step.Length));
            }
        }

        _along = Math.Max(_along, along);
        OffMetres = best;
    }

    private Vector2D At(double along)
    {
        int i = SegmentAt(along);
        Vector2D step = _points[i + 1] - _points[i];
        return _points[i] + (step * ((along - _distances[i]) / step.Length));
    }

    /// <summary>The segment at a distance; beyond the end the last one, which is prolonged.</summary>
    private int SegmentAt(double along)
    {
        int at = Array.BinarySearch(_distances, along);
        return Math.Min(at >= 0 ? at : ~at - 1, _points.Length - 2);
    }
}
