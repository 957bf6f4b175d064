using Harvester.Capture.Ports;
using Harvester.Driving.Controllers;

namespace Harvester.Driving.Tests.Doubles;

/// <summary>Drives straight on at full throttle, whatever is ahead.</summary>
internal sealed class FullThrottle : IController
{
    public DrivingControls Drive(DrivingState state) => new(0, 1, 0);
}
