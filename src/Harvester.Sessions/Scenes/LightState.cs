namespace Harvester.Sessions.Scenes;

/// <summary>The lit lamp of a traffic light.</summary>
public enum LightState
{
    /// <summary>The state could not be determined.</summary>
    Unknown,

    /// <summary>The upper lamp: stop.</summary>
    Red,

    /// <summary>The middle lamp: clear the junction.</summary>
    Amber,

    /// <summary>The lower lamp: go.</summary>
    Green,
}
