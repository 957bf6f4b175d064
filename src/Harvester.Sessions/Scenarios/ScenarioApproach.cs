namespace Harvester.Sessions.Scenarios;

/// <summary>Where a road comes into a junction, seen by the ego.</summary>
public enum ScenarioApproach
{
    /// <summary>From the left.</summary>
    Left,

    /// <summary>From the right.</summary>
    Right,

    /// <summary>From the other side of the junction.</summary>
    Oncoming,
}
