namespace Harvester.Sessions.Scenarios;

/// <summary>What an actor is.</summary>
public enum ScenarioActorType
{
    /// <summary>A motor vehicle.</summary>
    Vehicle,

    /// <summary>A bicycle with its rider.</summary>
    Cyclist,

    /// <summary>A person on foot.</summary>
    Pedestrian,

    /// <summary>An animal.</summary>
    Animal,

    /// <summary>A thing.</summary>
    Object,
}
