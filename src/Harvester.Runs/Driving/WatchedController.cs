using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;
using Harvester.Sessions.Labels;

namespace Harvester.Runs.Driving;

/// <summary>A controller whose input is kept, as it is behind the noise of the indicators.</summary>
public sealed class WatchedController(IController controller) : IController
{
    /// <summary>The last input; null before the first.</summary>
    public DrivingState? Input { get; private set; }

    /// <summary>The controller's target; null if it is unknown.</summary>
    public DriveTarget? Target => (controller as IAimingController)?.Target;

    /// <inheritdoc/>
    public DrivingControls Drive(DrivingState state)
    {
        Input = state;
        return controller.Drive(state);
    }
}
