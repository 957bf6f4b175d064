using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// The ego off the rails: from the first time that it is driven from outside it moves as a car does, also while its own driver has
/// it again. Until then it follows its lane's line as all vehicles do.
/// </summary>
internal sealed class EgoCar(Vehicle ego, LaneGraph lanes)
{
    /// <summary>A body this near to a way's line is in the way of who drives there, metres.</summary>
    private const double InTheWay = 2.6;
    private const double HalfOrdinaryLane = 2.7;
    private const double MaxTurn = 1.2;

    private readonly CarLimits _limits = new();
    private LaneFinder? _finder;
    private CarState _state;
    private DrivingControls? _controls;

    /// <summary>Whether it moves as a car does.</summary>
    public bool IsLoose { get; private set; }

    /// <summary>Whether it is driven from outside in this tick.</summary>
    public bool IsDriven => _controls is not null;

    public void Drive(DrivingControls controls)
    {
        _controls = controls;
        if (!IsLoose)
        {
            Loosen();
        }
    }

    /// <summary>Puts it somewhere, standing; its height is that of the way there, if there is one within 3 m above or below.</summary>
    public void Reset(Vector3D position, double headingDegrees)
    {
        IsLoose = true;
        double yaw = Angles.ToRadians(headingDegrees + 90);
        _controls = null;
        Take(CarState.At(new Vector2D(position.X, position.Y), yaw, 0, _limits), position.Z, isTeleported: true);
        ego.StandingSeconds = 0;
    }

    /// <summary>Takes over where the vehicle has been put.</summary>
    public void Loosen()
    {
        IsLoose = true;
        Vector3D ground = Ground;
        Vector3D forward = ego.Pose.Axes.Forward;
        _state = CarState.At(new Vector2D(ground.X, ground.Y), Math.Atan2(forward.Y, forward.X), ego.Speed, _limits);
    }

    /// <summary>Stops it dead, as vehicles on their lanes stop before what is in their way.</summary>
    public void Stop() => _state = _state with { Speed = 0, YawRate = 0 };

    /// <summary>Moves it, by the controls given for this tick or else by its own driver.</summary>
    /// <param name="seconds">Time that passes.</param>
    /// <param name="ownAcceleration">What its own driver would do with the pedals, m/s².</param>
    /// <param name="isTaken">Whether another body is nearer to it, where it is, than so many metres.</param>
    public void Advance(double seconds, double ownAcceleration, Func<double, bool> isTaken)
    {
        CarState before = _state;
        bool wasTouching = isTaken(0);

        // Its own driver stops dead before what is in his way, as everybody in the traffic does; who is too near already may yet drive off.
        double room = _controls is null && !isTaken(TrafficFlow.Clearance) ? TrafficFlow.Clearance : 0;
        Vector3D forward = ego.Pose.Axes.Forward;
        double slope = forward.Z / Math.Sqrt(1 - (forward.Z * forward.Z));
        DrivingControls controls = _controls ?? OwnDriver.Controls(ego, _state, ownAcceleration, _limits);
        Take(_state.After(controls, slope, _limits, seconds), Ground.Z, isTeleported: false);
        if (isTaken(room))
        {
            // Who has run into something stands; it can drive on when that is gone.
            Take((wasTouching || _controls is null ? before : _state) with { Speed = 0, YawRate = 0 }, Ground.Z, isTeleported: false);
        }

        ego.StandingSeconds = _state.Speed > 0 ? 0 : ego.StandingSeconds + seconds;
    }

    /// <summary>The controls of a tick hold for no other.</summary>
    public void EndTick() => _controls = null;

    private Vector3D Ground => ego.Pose.Position + (ego.Pose.Axes.Up * ego.Model.Min.Z);

    private void Take(CarState state, double height, bool isTeleported)
    {
        _state = state;
        Vector2D origin = state.Origin(_limits);
        Vector3D point = new(origin.X, origin.Y, height);
        Vector3D level = new(state.Forward.X, state.Forward.Y, 0);
        _finder ??= new LaneFinder(lanes);
        List<LanePlace> near = [.. _finder.Near(point)];
        LanePlace place = Locate(near, point, level, isTeleported);
        Vector3D tangent = place.Path.Line.TangentAt(place.Distance);
        double slope = tangent.Z / Math.Sqrt(1 - (tangent.Z * tangent.Z)) * Math.Cos(Horizontal.Turn(tangent, level));
        Axes axes = Horizontal.AxesAlong((level + (Horizontal.Up * slope)).Normalized());
        bool isOnWay = place.Beyond == 0 && Math.Abs(place.RightOffset) < LaneFinder.Reach;
        Vector3D ground = isOnWay ? point with { Z = place.Path.Line.PositionAt(place.Distance).Z } : point;
        Vector2D velocity = state.Velocity(_limits);
        ego.MoveFreely(
            place,
            new Pose(ground - (axes.Up * ego.Model.Min.Z), axes),
            state.Speed,
            new Vector3D(velocity.X, velocity.Y, slope * state.Speed),
            near.Where(other => Math.Abs(other.RightOffset) < InTheWay));
    }

    /// <summary>The place on its route as long as it keeps to that, else on the lane that it drives along.</summary>
    private LanePlace Locate(List<LanePlace> near, Vector3D point, Vector3D forward, bool isTeleported)
    {
        LanePlace onRoute = OnRoute(point);
        double half = onRoute.Path.Road?.Layout.LaneWidth / 2 ?? HalfOrdinaryLane;
        if (!isTeleported && Math.Abs(onRoute.RightOffset) <= half)
        {
            return onRoute;
        }

        return near
            .Where(place => TurnFrom(place) < MaxTurn)
            .OrderBy(place => Math.Abs(place.RightOffset) + (HalfOrdinaryLane * TurnFrom(place)))
            .Cast<LanePlace?>()
            .FirstOrDefault() ?? onRoute;

        double TurnFrom(LanePlace place) => Math.Abs(Horizontal.Turn(place.Path.Line.TangentAt(place.Distance), forward));
    }

    private LanePlace OnRoute(Vector3D point)
    {
        LanePlace place = LanePlace.Of(ego.Path, point, ego.Distance);
        for (int i = 1; i < ego.Route.Count && place.Beyond > 0; i++)
        {
            place = LanePlace.Of(ego.Route[i], point, 0);
        }

        return place;
    }
}
