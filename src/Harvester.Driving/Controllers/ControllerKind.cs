namespace Harvester.Driving.Controllers;

/// <summary>The controllers.</summary>
public enum ControllerKind
{
    /// <summary>The one published with DeepDriving.</summary>
    DeepDriving,

    /// <summary>Stanley's law of steering, with a time gap to the vehicle ahead.</summary>
    Stanley,
}
