namespace Harvester.Sessions.Scenarios;

/// <summary>When a scenario is over: as soon as one of these holds.</summary>
public sealed record ScenarioEnd
{
    /// <summary>Seconds after the beginning.</summary>
    public double Seconds { get; init; } = 15;

    /// <summary>Metres that the ego has driven; null for any number.</summary>
    public double? Metres { get; init; }

    /// <summary>Whether it is over once the ego has passed all actors by ten metres.</summary>
    public bool EgoPassedAll { get; init; }

    /// <summary>Whether it is over a second after the ego touched an actor.</summary>
    public bool Collision { get; init; }
}
