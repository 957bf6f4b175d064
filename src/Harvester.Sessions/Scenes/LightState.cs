namespace Harvester.Sessions.Scenes;

/// <summary>The lamp of a traffic light that burns.</summary>
public enum LightState
{
    /// <summary>The state could not be determined.</summary>
    Unknown,

    /// <summary>The upper one: stop.</summary>
    Red,

    /// <summary>The middle one: clear the junction.</summary>
    Amber,

    /// <summary>The lower one: go.</summary>
    Green,
}
