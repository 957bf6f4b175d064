using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Sessions.Scenarios;

/// <summary>What an actor does in an event.</summary>
/// <param name="Kind">The kind.</param>
public sealed record ScenarioAction(ScenarioActionKind Kind)
{
    /// <summary>The speed to reach, m/s; null to keep the present one.</summary>
    public double? Speed { get; init; }

    /// <summary>How fast the speed is reached, m/s², also for braking.</summary>
    public double Acceleration { get; init; } = 3;

    /// <summary>The side to which it goes, or the side of the door, -1 left or 1 right.</summary>
    public int Side { get; init; } = 1;

    /// <summary>Duration of a change of lanes, seconds.</summary>
    public double Seconds { get; init; } = 3;

    /// <summary>The way that it goes, metres.</summary>
    public double Metres { get; init; } = 30;

    /// <summary>Direction, degrees counter-clockwise from that of the ego's lane.</summary>
    public double Degrees { get; init; } = 90;

    /// <summary>Where it drives at the junction.</summary>
    public MapTurn Turn { get; init; }

    /// <summary>Times since the beginning of the event, seconds, ascending, and the speeds then, m/s.</summary>
    public IReadOnlyList<(double Seconds, double Speed)> Profile { get; init; } = [];

    /// <summary>
    /// The points of a path: metres ahead and to the right of the ego's start along its lane, or world metres where <see cref="IsWorld"/>.
    /// </summary>
    public IReadOnlyList<Vector2D> Points { get; init; } = [];

    /// <summary>Whether the points are metres of the world.</summary>
    public bool IsWorld { get; init; }
}
