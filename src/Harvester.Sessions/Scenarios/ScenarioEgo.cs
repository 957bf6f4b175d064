using Harvester.Geometry.Maps;

namespace Harvester.Sessions.Scenarios;

/// <summary>What the ego does in a scenario.</summary>
public sealed record ScenarioEgo
{
    /// <summary>Its speed at the beginning, which its driver keeps while nothing is in the way, m/s.</summary>
    public double Speed { get; init; } = 10;

    /// <summary>Where it turns at the first junction.</summary>
    public MapTurn Turn { get; init; } = MapTurn.Straight;
}
