namespace Harvester.Driving.Scenarios;

/// <summary>Why a scenario is over.</summary>
public enum ScenarioOutcome
{
    /// <summary>Its time has passed.</summary>
    Time,

    /// <summary>The ego has driven the distance.</summary>
    Distance,

    /// <summary>The ego has passed all actors.</summary>
    PassedAll,

    /// <summary>The ego touched an actor.</summary>
    Collision,
}
