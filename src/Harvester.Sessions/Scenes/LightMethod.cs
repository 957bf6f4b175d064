namespace Harvester.Sessions.Scenes;

/// <summary>How the state of a traffic light was determined.</summary>
public enum LightMethod
{
    /// <summary>The state is not known.</summary>
    Unknown,

    /// <summary>Set by the driver of the light: the harvester in the real game, the simulation in a simulated one.</summary>
    Set,

    /// <summary>Read from the image.</summary>
    Observed,
}
