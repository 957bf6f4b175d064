namespace Harvester.Sessions.Scenarios;

/// <summary>What a condition looks at.</summary>
public enum ScenarioConditionKind
{
    /// <summary>Seconds since the beginning; at least the value.</summary>
    Seconds,

    /// <summary>Distance of an actor from the ego, metres, middle to middle; at most the value.</summary>
    Distance,

    /// <summary>Time until the ego and an actor meet if both go on as they do, seconds; at most the value.</summary>
    TimeToCollision,

    /// <summary>
    /// Time until the ego comes to an actor or, without one, to the junction, at its present speed, seconds; at most the value.
    /// </summary>
    EgoArrival,

    /// <summary>Distance of the ego from the junction's entry, metres; at most the value.</summary>
    EgoToJunction,

    /// <summary>Speed of the ego, m/s; at least the value.</summary>
    EgoFaster,

    /// <summary>Speed of the ego, m/s; at most the value.</summary>
    EgoSlower,

    /// <summary>Speed of an actor, m/s; at most the value.</summary>
    ActorSlower,

    /// <summary>How far an actor is ahead of the ego along its lane, metres, negative behind; at least the value.</summary>
    Ahead,

    /// <summary>Whether the light before the ego has a state.</summary>
    Light,

    /// <summary>Whether an event has begun.</summary>
    Begun,

    /// <summary>Whether an event has ended.</summary>
    Ended,
}
