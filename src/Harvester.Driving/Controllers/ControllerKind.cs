namespace Harvester.Driving.Controllers;

/// <summary>The control laws that drive by the indicators.</summary>
public enum ControllerKind
{
    /// <summary>The controller published with DeepDriving (<see cref="DeepDrivingController"/>).</summary>
    DeepDriving,

    /// <summary>Stanley's steering law, with a time gap to the vehicle ahead.</summary>
    Stanley,
}
