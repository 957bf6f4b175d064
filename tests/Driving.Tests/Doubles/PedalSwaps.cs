using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;

namespace Harvester.Driving.Tests.Doubles;

/// <summary>Counts how often a controller goes from the brake to the throttle.</summary>
internal sealed class PedalSwaps(IController controller) : IController
{
    private bool _wasBraking;

    public int Count { get; private set; }

    public DrivingControls Drive(DrivingState state)
    {
        DrivingControls controls = controller.Drive(state);
        Count += _wasBraking && controls.Throttle > 0 ? 1 : 0;
        _wasBraking = controls.Brake > 0;
        return controls;
    }
}
