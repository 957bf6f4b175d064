namespace Harvester.Sessions.Scenarios;

/// <summary>What a place must have for a scenario to happen there.</summary>
public sealed record ScenarioNeeds
{
    /// <summary>Number of lanes in the ego's direction, at least.</summary>
    public int Lanes { get; init; } = 1;

    /// <summary>Number of lanes to the left of the ego's, at least.</summary>
    public int LanesLeft { get; init; }

    /// <summary>Number of lanes to the right of the ego's, at least.</summary>
    public int LanesRight { get; init; }

    /// <summary>Whether there must be a lane of the other direction beside the ego's direction.</summary>
    public bool OncomingLane { get; init; }

    /// <summary>Whether the road must be a street, neither a motorway nor unpaved: one with pavements.</summary>
    public bool Street { get; init; }

    /// <summary>Metres from the ego's start on which the road neither meets a junction nor bends.</summary>
    public double StraightMetres { get; init; }

    /// <summary>Metres from the ego's start on which it can drive, across junctions too.</summary>
    public double Metres { get; init; } = 60;

    /// <summary>Whether a pedestrian crossing must lie ahead of the ego, between these distances, metres; null if none is needed.</summary>
    public (double From, double To)? Crossing { get; init; }

    /// <summary>The junction that must lie ahead of the ego; null if none is needed.</summary>
    public ScenarioJunction? Junction { get; init; }
}
