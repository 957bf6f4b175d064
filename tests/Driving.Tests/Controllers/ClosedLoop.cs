using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Driving.Tests.Controllers;

/// <summary>
/// A kinematic bicycle on a road of two directions, driven by a controller ten times a second: enough to see whether a law of steering is
/// stable. The road is straight, or has a bend; its line is the left edge of the leftmost lane.
/// </summary>
internal sealed class ClosedLoop(IController controller, LaneSection section, double steeringLockRadians)
{
    private const double Wheelbase = 2.9;
    private const double Step = 0.01;
    private const double Gravity = 9.81;
    private const int StepsPerControl = 10;

    private double _headingRadians;

    /// <summary>Metres to the right of the left edge of the leftmost lane.</summary>
    public double Offset { get; set; } = section.LaneWidth / 2;

    /// <summary>Radians to the left of the road's direction.</summary>
    public double Yaw { get; set; }

    public double Speed { get; set; } = 10;

    /// <summary>Rise of the road per metre.</summary>
    public double Slope { get; init; }

    /// <summary>Along the road's line.</summary>
    public double Along { get; private set; }

    /// <summary>Where the road's line is an arc, metres along it, and how it bends there, 1/m, positive to the left.</summary>
    public (double From, double To, double Curvature) Bend { get; init; }

    /// <summary>How far ahead the angle is measured, metres along the road's line.</summary>
    public double LookAhead { get; init; }

    /// <summary>Along the road, metres; moves at its own speed.</summary>
    public (int Lane, double Along, double Speed)? Lead { get; set; }

    public void Run(double seconds, Action<ClosedLoop>? observe = null)
    {
        int controls = (int)Math.Round(seconds / (Step * StepsPerControl));
        for (int i = 0; i < controls; i++)
        {
            DrivingControls command = controller.Drive(State());
            for (int step = 0; step < StepsPerControl; step++)
            {
                Speed = Math.Max(0, Speed + (((2 * command.Throttle) - (8 * command.Brake) - (Gravity * Slope)) * Step));
                // On the outside of a bend the car drives a longer distance than the line: the same turn at a larger radius.
                double curvature = Along >= Bend.From && Along < Bend.To ? Bend.Curvature : 0;
                double along = Speed * Math.Cos(Yaw) / (1 + (curvature * Offset)) * Step;
                Along += along;
                Offset -= Speed * Math.Sin(Yaw) * Step;
                double turned = Speed / Wheelbase * Math.Tan(command.Steering * steeringLockRadians) * Step;
                Yaw += turned - (curvature * along);
                _headingRadians += turned;
                Lead = Lead is { } lead ? lead with { Along = lead.Along + (lead.Speed * Step) } : null;
            }

            observe?.Invoke(this);
        }
    }

    private DrivingState State()
    {
        VehicleAhead[] vehicles = Lead is { } lead ? [new(lead.Lane, lead.Along - Along)] : [];
        LaneIndicators at = IndicatorCalculator.Compute(
            RoadHeading(Along + LookAhead) - RoadHeading(Along) - Yaw,
            Offset,
            section,
            vehicles
        );
        return new DrivingState(at, TorcsEquivalent.Of(at, section), IsFast: Bend.Curvature == 0, Speed)
        {
            HeadingRadians = _headingRadians,
        };
    }

    private double RoadHeading(double along) => Bend.Curvature * (Math.Clamp(along, Bend.From, Bend.To) - Bend.From);
}
