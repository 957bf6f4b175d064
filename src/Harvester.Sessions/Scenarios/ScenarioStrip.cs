namespace Harvester.Sessions.Scenarios;

/// <summary>Where beside a carriageway an actor begins.</summary>
public enum ScenarioStrip
{
    /// <summary>Where vehicles are parked.</summary>
    Parking,

    /// <summary>On the pavement, or on the verge of a road without one.</summary>
    Pavement,
}
