namespace Harvester.Geometry.Roads;

/// <summary>
/// A car's position on the road network. Without a road (<see cref="HasRoad"/> is false) only <see cref="Outcome"/> is meaningful.
/// </summary>
public readonly record struct RoadMatch
{
    /// <summary>Whether road and lane are known, and if not, why.</summary>
    public RoadMatchOutcome Outcome { get; init; }

    /// <summary>Index of the link.</summary>
    public int Link { get; init; }

    /// <summary>Whether the car drives the link from its start to its end.</summary>
    public bool IsForward { get; init; }

    /// <summary>Parameter of the closest point of the link's <see cref="RoadCurve"/>, 0 to 1 from the link's start.</summary>
    public double Parameter { get; init; }

    /// <summary>The lanes of the car's direction.</summary>
    public LaneSection Section { get; init; }

    /// <summary>Left edge of the leftmost lane, metres to the right of the centre line in the car's direction.</summary>
    public double LeftEdge { get; init; }

    /// <summary>The car's position, metres to the right of the left edge of the leftmost lane.</summary>
    public double OffsetFromLeftEdge { get; init; }

    /// <summary>The lane, 0 the leftmost of the car's direction; null outside the lanes.</summary>
    public int? Lane { get; init; }

    /// <summary>
    /// Direction of the road minus direction of the car, radians in (-pi, pi]; positive if the car points to the right of the road, as in
    /// TORCS.
    /// </summary>
    public double HeadingError { get; init; }

    /// <summary>
    /// Probability of the road, from 0 to 1, against the next best road and against a road missing from the data, if the misfits were
    /// independent and normal. For comparison only; not a measured frequency.
    /// </summary>
    public double Confidence { get; init; }

    /// <summary>Whether a junction is so close along the road that lanes are not defined.</summary>
    public bool InJunction { get; init; }

    /// <summary>
    /// Whether there is a road: true unless the outcome is <see cref="RoadMatchOutcome.NoRoadNear"/> or <see
    /// cref="RoadMatchOutcome.NotAlongAnyRoad"/>.
    /// </summary>
    public bool HasRoad => Outcome >= RoadMatchOutcome.BesideTheLanes;

    /// <summary>How far the car is to the right of the middle of its lane, metres; null outside the lanes.</summary>
    public double? OffsetFromLaneCentre => Lane is { } lane ? OffsetFromLeftEdge - Section.MiddleOf(lane) : null;
}
