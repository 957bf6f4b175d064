namespace Harvester.Capture.Ports;

/// <summary>The indicators of a staged vehicle that blink.</summary>
public enum StageIndicators
{
    /// <summary>None.</summary>
    Off,

    /// <summary>Those on the left.</summary>
    Left,

    /// <summary>Those on the right.</summary>
    Right,

    /// <summary>All: the hazard lights.</summary>
    Hazard,
}
