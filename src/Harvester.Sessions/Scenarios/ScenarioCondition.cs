using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Scenarios;

/// <summary>A condition for an event.</summary>
/// <param name="Kind">What it looks at.</param>
/// <param name="Value">The limit, in the unit of the kind; 0 where there is none.</param>
public sealed record ScenarioCondition(ScenarioConditionKind Kind, double Value)
{
    /// <summary>Id of the actor that it looks at; null for none.</summary>
    public string? Actor { get; init; }

    /// <summary>Id of the event that it looks at; null for none.</summary>
    public string? Event { get; init; }

    /// <summary>The state of the light that it looks at.</summary>
    public LightState Light { get; init; }
}
