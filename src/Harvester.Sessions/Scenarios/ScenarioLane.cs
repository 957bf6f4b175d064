namespace Harvester.Sessions.Scenarios;

/// <summary>A lane, seen from the ego's.</summary>
public enum ScenarioLane
{
    /// <summary>The ego's own.</summary>
    Ego,

    /// <summary>The next to the left, of the same direction.</summary>
    Left,

    /// <summary>The next to the right, of the same direction.</summary>
    Right,

    /// <summary>The nearest of the other direction.</summary>
    Oncoming,
}
