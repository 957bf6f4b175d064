using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Controllers;
using Harvester.Geometry.Lanes;

namespace Harvester.Driving.Tests.Controllers;

/// <summary>A kinematic bicycle on a straight road, driven by a controller ten times a second: enough to see whether a law of steering is stable.</summary>
internal sealed class ClosedLoop(IController controller, LaneSection section, double steeringLockRadians)
{
    private const double Wheelbase = 2.9;
    private const double Step = 0.01;
    private const int StepsPerControl = 10;

    /// <summary>Metres to the right of the left edge of the leftmost lane.</summary>
    public double Offset { get; set; } = section.LaneWidth / 2;

    /// <summary>Radians to the left of the road's direction.</summary>
    public double Yaw { get; set; }

    public double Speed { get; set; } = 10;

    public double Along { get; private set; }

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
                Speed = Math.Max(0, Speed + (((2 * command.Throttle) - (8 * command.Brake)) * Step));
                Along += Speed * Math.Cos(Yaw) * Step;
                Offset -= Speed * Math.Sin(Yaw) * Step;
                Yaw += Speed / Wheelbase * Math.Tan(command.Steering * steeringLockRadians) * Step;
                Lead = Lead is { } lead ? lead with { Along = lead.Along + (lead.Speed * Step) } : null;
            }

            observe?.Invoke(this);
        }
    }

    private DrivingState State()
    {
        VehicleAhead[] vehicles = Lead is { } lead ? [new(lead.Lane, lead.Along - Along)] : [];
        LaneIndicators at = IndicatorCalculator.Compute(-Yaw, Offset, section, vehicles);
        return new DrivingState(at, TorcsEquivalent.Of(at, section), IsFast: true, Speed);
    }
}
