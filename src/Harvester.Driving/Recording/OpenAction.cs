using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Recording;

/// <summary>The action of the newest frame, while it happens.</summary>
/// <param name="timeSeconds">Time of the frame, seconds.</param>
/// <param name="speed">Speed at the frame, m/s.</param>
internal sealed class OpenAction(double timeSeconds, double speed)
{
    /// <summary>
    /// One minute at 60 ticks per second, because perhaps no frame follows for long. Beyond that, the first tick and the newest are kept.
    /// </summary>
    private const int MaxTicks = 3600;

    private readonly List<(DriveTick Tick, bool IsDisturbed)> _ticks = [];
    private DriveControls? _answer;
    private double? _answerSeconds;
    private IReadOnlyList<double>? _indicators;
    private DriveTarget? _target;

    /// <summary>Time of the frame, seconds.</summary>
    public double TimeSeconds => timeSeconds;

    /// <summary>Number of the frame on the live bridge; null without a bridge.</summary>
    public long? BridgeFrame { get; set; }

    /// <summary>Number of a later frame on the live bridge that shows the same moment; null for none.</summary>
    public long? RepeatedAs { get; set; }

    /// <summary>Acceleration and turning rate at the frame; null where unknown.</summary>
    public (Vector3D? Acceleration, Vector3D? AngularRate) Inertia { get; init; }

    /// <summary>What a simulated game knows at the frame; null in GTA V.</summary>
    public DrivingTruth? Truth { get; set; }

    /// <summary>Takes the answer to the frame; later answers, and answers to other frames, are not taken.</summary>
    public void Answer(DrivingControls controls, IReadOnlyList<double>? indicators, DriveTarget? target, long? answered, double nowSeconds)
    {
        if (_answer is null && (answered is null || BridgeFrame is null || answered == BridgeFrame || answered == RepeatedAs))
        {
            _answer = Recorded(controls);
            _answerSeconds = nowSeconds - timeSeconds;
            _indicators = indicators;
            _target = target;
        }
    }

    /// <summary>Adds a tick after the frame.</summary>
    public void Add(DriveTick tick, bool isDisturbed)
    {
        if (_ticks.Count == MaxTicks)
        {
            _ticks.RemoveAt(1);
        }

        _ticks.Add((tick, isDisturbed));
    }

    /// <summary>Moves the ticks after a time to the action of a frame of that time.</summary>
    public void MoveTicksTo(OpenAction next, double afterSeconds)
    {
        next._ticks.AddRange(_ticks.Where(tick => tick.Tick.TimeSeconds > afterSeconds));
        _ticks.RemoveAll(tick => tick.Tick.TimeSeconds > afterSeconds);
    }

    /// <summary>The label, once no tick follows.</summary>
    public DriveLabel Label()
    {
        DriverKind driver = _ticks.Count > 0 ? _ticks[0].Tick.Driver : DriverKind.None;
        DriveControls? applied = _ticks.Count > 0 ? _ticks[0].Tick.Applied : null;
        bool isBuiltIn = _ticks.Count > 0 && driver == DriverKind.BuiltIn;
        return new DriveLabel(driver, speed)
        {
            Controls = isBuiltIn ? applied : _answer,
            AnswerSeconds =
                isBuiltIn && applied is not null ? 0
                : isBuiltIn ? null
                : _answerSeconds,
            Applied = applied,
            IsDisturbed = _ticks.Count > 0 && _ticks[0].IsDisturbed,
            Indicators = isBuiltIn ? null : _indicators,
            Target = isBuiltIn ? null : _target,
            Route = Truth?.Route,
            RouteMetres = Truth?.RouteMetres,
            Acceleration = Inertia.Acceleration,
            AngularRate = Inertia.AngularRate,
            BridgeFrame = BridgeFrame,
            Truth = Truth is { } truth
                ? new DriveTruth(truth.DrivenMetres, truth.IsOutsideLanes, truth.HasStopSign)
                {
                    Collision = truth.Collision,
                    LaneOffsetMetres = truth.LaneOffsetMetres,
                    LaneAngleRadians = truth.LaneAngleRadians,
                    Light = truth.Light,
                    RedLightsRun = truth.RedLightsRun,
                    StopSignsRun = truth.StopSignsRun,
                    Repositioned = truth.Repositioned,
                }
                : null,
            Ticks = [.. _ticks.Select(tick => tick.Tick)],
        };
    }

    private static DriveControls Recorded(DrivingControls controls) => new(controls.Steering, controls.Throttle, controls.Brake);
}
