
using Harvester.Capture.Ports;

namespace Harvester.Driving.Controllers;

/// <summary>Drives a car by the indicators, asked about ten times a second.</summary>
public interface IController
{
    /// <summary>What to do now.</summary>
    DrivingControls Drive(DrivingState state);
}
