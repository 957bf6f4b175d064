using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>Drives a car by the indicators; called about ten times per second.</summary>
public interface IController
{
    /// <summary>Returns the controls for the current state.</summary>
    DrivingControls Drive(DrivingState state);
}
