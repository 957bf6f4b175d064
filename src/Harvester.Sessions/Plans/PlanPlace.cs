using Harvester.Geometry;

namespace Harvester.Sessions.Plans;

/// <summary>A place of a plan and the drive that begins there.</summary>
/// <param name="Name">Its name within the plan.</param>
public sealed record PlanPlace(string Name)
{
    /// <summary>Where the drive begins, metres, world; null for places that are yet to be chosen, and for the first of the path.</summary>
    public Vector2D? Point { get; init; }

    /// <summary>The direction in which the drive begins, degrees counter-clockwise from north; null for that of the lane.</summary>
    public double? HeadingDegrees { get; init; }

    /// <summary>Number of places to choose all over the roads, in place of one; null for one place.</summary>
    public int? Spread { get; init; }

    /// <summary>Name, code or model of a space of interest before which the drive begins; null for none.</summary>
    public string? Space { get; init; }

    /// <summary>Distance from the space at which the drive begins, metres.</summary>
    public double MetresBefore { get; init; }

    /// <summary>The points along which to drive, metres, world; empty to follow the road.</summary>
    public IReadOnlyList<Vector2D> Path { get; init; } = [];

    /// <summary>The scenario file that is staged there, a path beside the plan; null for ordinary traffic. A place that has nothing
    /// else is any where the scenario can happen.</summary>
    public string? Scenario { get; init; }

    /// <summary>The drive ends after this many seconds of the game's time; null without such a limit.</summary>
    public double? Seconds { get; init; }

    /// <summary>The drive ends after this many metres; null without such a limit.</summary>
    public double? Metres { get; init; }

    /// <summary>Where the drive begins, metres, world; null for places that are yet to be chosen.</summary>
    public Vector2D? Start => Path.Count > 0 ? Path[0] : Point;
}
