namespace Harvester.Capture.Labels;

/// <summary>How the state of a traffic light is known.</summary>
public enum LightMethod
{
    /// <summary>It is not.</summary>
    Unknown,

    /// <summary>The harvester itself has set it.</summary>
    Set,

    /// <summary>It was read from the picture.</summary>
    Observed,
}
