using Harvester.Geometry;

namespace Harvester.Sessions.Scenarios;

/// <summary>Where an actor begins.</summary>
/// <param name="Kind">To what the place is related.</param>
public sealed record ScenarioStart(ScenarioPlaceKind Kind)
{
    /// <summary>Metres along the lanes from the middle of the ego to that of the actor, negative behind; of lanes and roadsides.</summary>
    public double MetresAhead { get; init; }

    /// <summary>The lane; of the kind lane.</summary>
    public ScenarioLane Lane { get; init; }

    /// <summary>The strip beside the carriageway; of the kind roadside.</summary>
    public ScenarioStrip Strip { get; init; }

    /// <summary>The side of the road, -1 left or 1 right; of roadsides and crossings.</summary>
    public int Side { get; init; } = 1;

    /// <summary>Metres to the right of that place, seen in the direction of the ego.</summary>
    public double MetresRight { get; init; }

    /// <summary>Direction in which it looks, degrees counter-clockwise from that of its lane, or of the ego's at a roadside.</summary>
    public double HeadingDegrees { get; init; }

    /// <summary>Where its road comes into the junction; of the kind junction.</summary>
    public ScenarioApproach Approach { get; init; }

    /// <summary>Metres before the end of its lane at the junction; null with <see cref="SecondsBefore"/>.</summary>
    public double? MetresBefore { get; init; }

    /// <summary>
    /// It begins so far away that at its speed it is so many seconds earlier than the ego at the point where their ways meet; null with
    /// <see cref="MetresBefore"/>.
    /// </summary>
    public double? SecondsBefore { get; init; }

    /// <summary>The point, metres, world; of the kind point.</summary>
    public Vector2D Point { get; init; }
}
