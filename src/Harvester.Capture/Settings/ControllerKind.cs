namespace Harvester.Capture.Settings;

/// <summary>What drives by the indicators that a peer sends.</summary>
public enum ControllerKind
{
    /// <summary>The one published with DeepDriving.</summary>
    DeepDriving,

    /// <summary>Stanley's law of steering, with a time gap to the vehicle ahead.</summary>
    Stanley,
}
