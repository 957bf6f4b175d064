using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Crashes;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>
/// The ego as a freely moving car: from the first controls of a client or controller on it moves by car physics, even when its built-in
/// driver has taken over again. Until then it follows its lane's line like all vehicles.
/// </summary>
internal sealed class EgoCar(Vehicle ego, LaneGraph lanes, EgoManoeuvres? manoeuvres)
{
    /// <summary>A body closer than this to a path's line blocks it, metres.</summary>
    public const double InTheWay = 2.6;
    private const double HalfOrdinaryLane = 2.7;
    private const double MaxTurn = 1.2;

    private CarLimits _limits = new();
    private LaneFinder? _finder;
    private CarState _state;
    private DrivingControls? _controls;

    /// <summary>Whether it moves by car physics.</summary>
    public bool IsLoose { get; private set; }

    /// <summary>Whether it has controls for this tick.</summary>
    public bool IsDriven => _controls is not null;

    /// <summary>The controls that moved it last; null while it follows its lane's line.</summary>
    public DrivingControls? Applied { get; private set; }

    /// <summary>What its built-in driver does; null while it follows its lane's line or is driven by another program.</summary>
    public Manoeuvre? Manoeuvre { get; private set; }

    public void Drive(DrivingControls controls)
    {
        _controls = controls;
        if (!IsLoose)
        {
            Loosen();
        }
    }

    /// <summary>
    /// Places it at a position, at rest; its height is that of the path there, if there is one within 3 m above or below.
    /// </summary>
    public void Reset(Vector3D position, double headingDegrees)
    {
        IsLoose = true;
        double yaw = Angles.ToRadians(headingDegrees + 90);
        _controls = null;
        Take(CarState.At(new Vector2D(position.X, position.Y), yaw, 0, _limits), position.Z, isTeleported: true);
        ego.StandingSeconds = 0;
        ego.Wreck = null;
        manoeuvres?.Reset(0);
    }

    /// <summary>Sets what the tyres can do: full brakes and grip become as much weaker as the braking on the road.</summary>
    public void SetGrip(RoadGrip grip)
    {
        CarLimits dry = new();
        double share = grip.Braking / RoadGrip.Dry.Braking;
        _limits = dry with { Braking = dry.Braking * share, Grip = dry.Grip * share };
    }

    /// <summary>Notes that it slides or stands after an impact, on locked wheels, whatever its driver does.</summary>
    public void Slide()
    {
        IsLoose = true;
        Manoeuvre = null;
        Applied = DrivingControls.Stop;
    }

    /// <summary>Takes over the vehicle's pose.</summary>
    public void Loosen()
    {
        IsLoose = true;
        Vector3D ground = Ground;
        Vector3D forward = ego.Pose.Axes.Forward;
        _state = CarState.At(new Vector2D(ground.X, ground.Y), Math.Atan2(forward.Y, forward.X), ego.Speed, _limits);
        manoeuvres?.Reset(0);
    }

    /// <summary>Lets its built-in driver decide what to do in this tick.</summary>
    /// <param name="seconds">Time that passes.</param>
    /// <param name="occupation">The vehicles on the lanes.</param>
    /// <param name="isTaken">Whether another body stands where its footprint would be.</param>
    public void Decide(double seconds, LaneOccupation occupation, Func<Footprint, bool> isTaken)
    {
        double offset = LanePlace.Of(ego.Path, Ground, ego.Distance).RightOffset;
        if (IsDriven)
        {
            Manoeuvre = null;
            manoeuvres?.Reset(offset);
        }
        else if (manoeuvres is not null)
        {
            manoeuvres.Tick(seconds, offset, occupation, (goal, metres) => IsClear(goal, metres, isTaken));
            Manoeuvre = manoeuvres.Reported(occupation);
        }
    }

    /// <summary>Whether its built-in driver is still to begin the drift that was asked for.</summary>
    public bool IsPrompted => manoeuvres?.IsPrompted ?? false;

    /// <summary>Lets its built-in driver drift onto a marking as soon as it can, if it ever does.</summary>
    /// <param name="side">-1 for a marking to the left, 1 for one to the right.</param>
    public void Prompt(int side) => manoeuvres?.Prompt(side);

    /// <summary>Stops it at once, as vehicles on their lanes stop before an obstacle.</summary>
    public void Stop() => _state = _state with { Speed = 0, YawRate = 0 };

    /// <summary>Moves it by the controls given for this tick or else by its built-in driver.</summary>
    /// <param name="seconds">Time that passes.</param>
    /// <param name="ownAcceleration">The acceleration that its built-in driver wants, m/s².</param>
    /// <param name="isTaken">Whether another body is closer to it than a distance in metres.</param>
    public void Advance(double seconds, double ownAcceleration, Func<double, bool> isTaken)
    {
        CarState before = _state;
        bool wasTouching = isTaken(0);

        // Its built-in driver stops at once before an obstacle, like all traffic; one that is too close already may still drive off.
        double room = _controls is null && !isTaken(TrafficFlow.Clearance) ? TrafficFlow.Clearance : 0;
        Vector3D forward = ego.Pose.Axes.Forward;
        double slope = forward.Z / Math.Sqrt(1 - (forward.Z * forward.Z));
        DrivingControls controls = _controls ?? OwnDriver.Controls(ego, _state, ownAcceleration, manoeuvres?.Offset ?? 0, _limits);
        Applied = controls;
        Take(_state.After(controls, slope, _limits, seconds), Ground.Z, isTeleported: false);
        if (isTaken(room))
        {
            // A car that has hit something stands still; it can drive on when that is gone.
            Take((wasTouching || _controls is null ? before : _state) with { Speed = 0, YawRate = 0 }, Ground.Z, isTeleported: false);
        }

        ego.StandingSeconds = _state.Speed > 0 ? 0 : ego.StandingSeconds + seconds;
    }

    /// <summary>Ends the tick; its controls apply to no other.</summary>
    public void EndTick() => _controls = null;

    /// <summary>Whether nothing stands beside its route, from its front on.</summary>
    private bool IsClear(double rightOffset, double metres, Func<Footprint, bool> isTaken)
    {
        const double step = 3;
        const double room = 0.3;
        for (double ahead = step; ahead <= metres; ahead += step)
        {
            Footprint on = ego.FootprintAhead(ahead);
            Footprint beside = on with { Centre = on.Centre + (Horizontal.RightOf(on.Forward) * rightOffset) };
            if (isTaken(beside.Grown(room)))
            {
                return false;
            }
        }

        return true;
    }

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
            near.Where(other => Math.Abs(other.RightOffset) < InTheWay)
        );
    }

    /// <summary>The position on its route as long as it follows that, otherwise on the lane along which it drives.</summary>
    private LanePlace Locate(List<LanePlace> near, Vector3D point, Vector3D forward, bool isTeleported)
    {
        LanePlace onRoute = OnRoute(point);
        double half = onRoute.Path.Road?.Layout.LaneWidth / 2 ?? HalfOrdinaryLane;
        if (!isTeleported && Math.Abs(onRoute.RightOffset) <= half)
        {
            return onRoute;
        }

        return near.Where(place => TurnFrom(place) < MaxTurn)
                .OrderBy(place => Math.Abs(place.RightOffset) + (HalfOrdinaryLane * TurnFrom(place)))
                .Cast<LanePlace?>()
                .FirstOrDefault()
            ?? onRoute;

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
