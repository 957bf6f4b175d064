using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Geometry;
using Harvester.Sessions.Labels;

namespace Harvester.Driving.Recording;

/// <summary>The action of the newest frame, while it happens.</summary>
/// <param name="timeSeconds">Time of the frame, seconds.</param>
/// <param name="speed">Speed at the frame, m/s.</param>
/// <param name="bridgeFrame">Number of the frame on the live bridge; null without a bridge.</param>
internal sealed class OpenAction(double timeSeconds, double speed, long? bridgeFrame)
{
    private readonly List<DriveTick> _ticks = [];
    private DriverKind _driver;
    private bool _isDisturbed;
    private DriveControls? _answer;
    private double? _answerSeconds;
    private IReadOnlyList<double>? _indicators;
    private DriveTarget? _target;

    /// <summary>Acceleration and turning rate at the frame; null where unknown.</summary>
    public (Vector3D? Acceleration, Vector3D? AngularRate) Inertia { get; init; }

    /// <summary>What a simulated game knows at the frame; null in GTA V.</summary>
    public DrivingTruth? Truth { get; init; }

    /// <summary>Takes the answer to the frame; later answers, and answers to earlier frames, are those of other frames.</summary>
    public void Answer(
        DrivingControls controls, IReadOnlyList<double>? indicators, DriveTarget? target, long? answered, double nowSeconds)
    {
        if (_answer is null && !(answered < bridgeFrame))
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
        if (_ticks.Count == 0)
        {
            _driver = tick.Driver;
            _isDisturbed = isDisturbed;
        }

        _ticks.Add(tick);
    }

    /// <summary>The label, once no tick follows.</summary>
    public DriveLabel Label()
    {
        DriveControls? applied = _ticks.Count > 0 ? _ticks[0].Applied : null;
        bool isBuiltIn = _ticks.Count > 0 && _driver == DriverKind.BuiltIn;
        return new DriveLabel(_driver, speed)
        {
            Controls = isBuiltIn ? applied : _answer,
            AnswerSeconds = isBuiltIn && applied is not null ? 0 : isBuiltIn ? null : _answerSeconds,
            Applied = applied,
            IsDisturbed = _isDisturbed,
            Indicators = isBuiltIn ? null : _indicators,
            Target = isBuiltIn ? null : _target,
            Route = Truth?.Route,
            RouteMetres = Truth?.RouteMetres,
            Acceleration = Inertia.Acceleration,
            AngularRate = Inertia.AngularRate,
            BridgeFrame = bridgeFrame,
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
            Ticks = _ticks,
        };
    }

    private static DriveControls Recorded(DrivingControls controls) => new(controls.Steering, controls.Throttle, controls.Brake);
}
