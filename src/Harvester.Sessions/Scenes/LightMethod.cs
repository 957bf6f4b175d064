namespace Harvester.Sessions.Scenes;

/// <summary>How the state of a traffic light is known.</summary>
public enum LightMethod
{
    /// <summary>The state is not known.</summary>
    Unknown,

    /// <summary>Who drives the light told: the harvester itself in the real game, the simulation in a simulated one.</summary>
    Set,

    /// <summary>It was read from the picture.</summary>
    Observed,
}
