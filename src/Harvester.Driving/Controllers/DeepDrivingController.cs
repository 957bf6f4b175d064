using Harvester.Capture.Ports;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Controllers;

/// <summary>
/// The controller published with DeepDriving for TORCS roads of up to three lanes, reimplemented from its rules and constants. It steers by
/// steering = (angle - centre / 8) / 0.541 / damping towards the centre line of the lane it is in or moves to, changes lane when a vehicle
/// is within 15 m and the neighbouring lane was free for six seconds, and otherwise slows down behind it by the optimal-velocity model. The
/// drift back to a preferred lane is left out: it depends on the number of lanes, which no indicator gives. It uses <see
/// cref="DrivingState.TorcsEquivalent"/>, ten times per second, and the angle at the car, as in TORCS. If the angle is measured farther
/// ahead, the one at the car is derived from earlier ones, and the curvature found that way is fed forward.
/// </summary>
public sealed class DeepDrivingController : IAimingController
{
    private const double RoadWidth = 8.0;
    private const double SteeringLockRadians = 0.541052;
    private const double BlockedWithinMetres = 15;
    private const double MaxLaneWidth = 5.5;
    private const double NoLaneBeyond = 8;
    private const double SteadySteering = 0.2;

    /// <summary>The published maximum speed, m/s.</summary>
    public const double MaxSpeed = 20;

    private const int FramesToClear = 60;
    private const int FramesCarriedOver = 30;
    private const int TrendLength = 5;
    private const double PeriodSeconds = 0.1;

    /// <summary>Delay from a command to its effect, seconds: the car steers into bends this much earlier.</summary>
    private const double SteeringLeadSeconds = 0.2;

    private readonly RoadAhead? _road;
    private readonly double _lockShare;
    private readonly double _maxSpeed;
    private readonly double _vehicleAllowance;
    private readonly Queue<double> _steerings = new(new double[TrendLength]);
    private readonly LaneClearance _left = new();
    private readonly LaneClearance _right = new();
    private LaneManoeuvre _manoeuvre;
    private double _previousMl = -2;
    private double _previousMr = 2;

    /// <summary>Creates a controller for indicators whose angle is measured at the car, as in TORCS.</summary>
    /// <param name="steeringLockRadians">Angle of the car's front wheels at full lock, radians; by default that of TORCS.</param>
    /// <param name="vehicleAllowanceMetres">
    /// Subtracted from the distances to vehicles, metres: the published controller stops 5 m from a vehicle, centre to centre, which suits
    /// only the short cars of TORCS.
    /// </param>
    /// <param name="maxSpeed">Speed on a free straight road, m/s, greater than 0; by default 20, as published.</param>
    public DeepDrivingController(
        double steeringLockRadians = SteeringLockRadians,
        double vehicleAllowanceMetres = 0,
        double maxSpeed = MaxSpeed
    )
    {
        _maxSpeed = maxSpeed;
        _lockShare = SteeringLockRadians / steeringLockRadians;
        _vehicleAllowance = vehicleAllowanceMetres;
    }

    /// <summary>Creates a controller for indicators whose angle is measured ahead of the car.</summary>
    /// <param name="car">Steering lock, wheelbase and other traits of the driven car.</param>
    /// <param name="lookAheadMetres">Distance ahead of the car at which the angle is measured, metres, 0 or more.</param>
    /// <param name="vehicleAllowanceMetres">Subtracted from the distances to vehicles, metres.</param>
    /// <param name="maxSpeed">Speed on a free straight road, m/s, greater than 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="car"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="lookAheadMetres"/> is negative.</exception>
    public DeepDrivingController(CarTraits car, double lookAheadMetres, double vehicleAllowanceMetres, double maxSpeed)
        : this((car ?? throw new ArgumentNullException(nameof(car))).SteeringLockRadians, vehicleAllowanceMetres, maxSpeed) =>
        _road = new RoadAhead(lookAheadMetres, PeriodSeconds, car, new PlaceBesideLine());

    /// <summary>The speed that it wants, also behind a vehicle. Its line is one on a road of TORCS, so it is not known in metres.</summary>
    public DriveTarget? Target { get; private set; }

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        _ = state ?? throw new ArgumentNullException(nameof(state));
        LaneIndicators at = state.TorcsEquivalent;
        _road?.Observe(state);
        _left.Observe(at.DistLL.Value - _vehicleAllowance);
        _right.Observe(at.DistRR.Value - _vehicleAllowance);
        double ahead = at.DistMM.Value - _vehicleAllowance;
        bool isBlocked = _manoeuvre == LaneManoeuvre.Keep && ahead < BlockedWithinMetres && !TryChangeLane(at);
        double damping = Steer(at, out double centre);

        // The published law: the angle between road and car minus the distance of the line in road widths, as a fraction of the full lock,
        // divided by a damping that depends on the manoeuvre.
        double angle = _road?.At(0).Angle ?? at.Angle.Value;
        double steering = (angle - (centre / RoadWidth)) / SteeringLockRadians / damping;
        if (_manoeuvre == LaneManoeuvre.Keep && damping > 1 && steering > 0.1)
        {
            steering *= (2.5 * steering) + 0.75;
        }

        double speed = state.SpeedMetresPerSecond;
        steering += (_road?.WheelAngleAt(speed * SteeringLeadSeconds, speed) ?? 0) / SteeringLockRadians;
        _steerings.Dequeue();
        _steerings.Enqueue(steering);
        return Controls(steering, state, isBlocked ? SpeedBehind(ahead) : double.PositiveInfinity);
    }

    private DrivingControls Controls(double steering, DrivingState state, double maxBehind)
    {
        // The more it has steered in the last half second, the slower, from 20 m/s down to 10 m/s; 10 m/s and 4.5 are the published
        // constants.
        double desired = state.IsFast ? MaxSpeed : Math.Max(10, MaxSpeed - (4.5 * Math.Abs(_steerings.Sum())));
        double wanted = Math.Min(Math.Min(desired, _maxSpeed), maxBehind);
        Target = new DriveTarget(wanted, null);
        double error = wanted - state.SpeedMetresPerSecond;
        double cut = Math.Max(-1, Math.Min(1, steering));
        double onWheel = cut * _lockShare;
        if (_road is { } road)
        {
            road.RequestedWheelAngle = cut * SteeringLockRadians;
        }

        return error >= 0 ? new DrivingControls(onWheel, 0.2 * (error + 1), 0) : new DrivingControls(onWheel, 0, 0.1 * -error);
    }

    /// <summary>
    /// The speed behind a vehicle at a distance by the optimal-velocity model, v = v_max (1 - e^(-c d / v_max - d0)) with the published c =
    /// 2.772 and d0 = -0.693: 0 at 5 m, 15 m/s at 15 m.
    /// </summary>
    private static double SpeedBehind(double distance)
    {
        const double c = 2.772;
        const double d = -0.693;
        return Math.Max(0, MaxSpeed * (1 - Math.Exp((-c / MaxSpeed * distance) - d)));
    }

    private bool TryChangeLane(LaneIndicators at)
    {
        double trend = _steerings.Sum();
        if (at.ToMarkingLL.Value > -NoLaneBeyond && _left.IsClear(FramesToClear) && trend is >= 0 and < SteadySteering)
        {
            _manoeuvre = LaneManoeuvre.LeaveToLeft;
            _left.Restart(FramesCarriedOver);
            _right.Restart(0);
            return true;
        }

        if (at.ToMarkingRR.Value < NoLaneBeyond && _right.IsClear(FramesToClear) && trend is <= 0 and > -SteadySteering)
        {
            _manoeuvre = LaneManoeuvre.LeaveToRight;
            _right.Restart(FramesCarriedOver);
            _left.Restart(0);
            return true;
        }

        return false;
    }

    /// <summary>Finds the line to steer towards, metres to the right of the car, and the damping.</summary>
    private double Steer(LaneIndicators at, out double centre)
    {
        // The middle between two markings is the mean of the distances to both: of the car's lane, and of the lanes on either side of a
        // marking that the car is on.
        bool isInLane = at.ToMarkingMR.Value - at.ToMarkingML.Value < MaxLaneWidth;
        bool isOnLeftMarking = at.ToMarkingL.Value > -5 && at.ToMarkingM.Value < 1.5;
        bool isOnRightMarking = at.ToMarkingR.Value < 5 && at.ToMarkingM.Value < 1.5;
        double lane = (at.ToMarkingML.Value + at.ToMarkingMR.Value) / 2;
        double leftOfMarking = (at.ToMarkingL.Value + at.ToMarkingM.Value) / 2;
        double rightOfMarking = (at.ToMarkingR.Value + at.ToMarkingM.Value) / 2;
        switch (_manoeuvre)
        {
            case LaneManoeuvre.LeaveToLeft:
                return Leave(
                    isInLane,
                    isOnLeftMarking,
                    (at.ToMarkingLL.Value + at.ToMarkingML.Value) / 2,
                    leftOfMarking,
                    LaneManoeuvre.ArriveFromRight,
                    out centre
                );
            case LaneManoeuvre.LeaveToRight:
                return Leave(
                    isInLane,
                    isOnRightMarking,
                    (at.ToMarkingRR.Value + at.ToMarkingMR.Value) / 2,
                    rightOfMarking,
                    LaneManoeuvre.ArriveFromLeft,
                    out centre
                );
            case LaneManoeuvre.ArriveFromRight:
                return Arrive(isInLane, isOnLeftMarking, lane, leftOfMarking, out centre);
            case LaneManoeuvre.ArriveFromLeft:
                return Arrive(isInLane, isOnRightMarking, lane, rightOfMarking, out centre);
            default:
                return Keep(at, isInLane, lane, leftOfMarking, rightOfMarking, out centre);
        }
    }

    private double Keep(LaneIndicators at, bool isInLane, double lane, double leftOfMarking, double rightOfMarking, out double centre)
    {
        if (!isInLane)
        {
            centre = -_previousMl > _previousMr ? leftOfMarking : rightOfMarking;
            return 0.3;
        }

        centre = lane;
        _previousMl = at.ToMarkingML.Value;
        _previousMr = at.ToMarkingMR.Value;
        return at.ToMarkingM.Value < 1 ? 0.4 : 1.5;
    }

    private double Leave(bool isInLane, bool isOnMarking, double next, double beyondMarking, LaneManoeuvre arrival, out double centre)
    {
        if (isInLane)
        {
            centre = isOnMarking ? (next + beyondMarking) / 2 : next;
            return 6;
        }

        centre = beyondMarking;
        _manoeuvre = arrival;
        return 20;
    }

    private double Arrive(bool isInLane, bool isOnMarking, double lane, double beyondMarking, out double centre)
    {
        centre =
            !isOnMarking ? lane
            : isInLane ? (lane + beyondMarking) / 2
            : beyondMarking;
        _manoeuvre = isOnMarking ? _manoeuvre : LaneManoeuvre.Keep;
        return 20;
    }
}
