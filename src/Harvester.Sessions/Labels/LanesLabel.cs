using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Sessions.Labels;

/// <summary>The lanes of a frame.</summary>
public sealed record LanesLabel
{
    /// <summary>Whether the lanes are known, and if not, why.</summary>
    public required LaneStatus Status { get; init; }

    /// <summary>The source of the roads: roadFile, game, simulation.</summary>
    public required string Source { get; init; }

    /// <summary>
    /// Probability of the road, 0 to 1; 0 without a road. See <see cref="Harvester.Geometry.Roads.RoadMatch.Confidence"/>.
    /// </summary>
    public double Confidence { get; init; }

    /// <summary>Whether a junction is so close along the road that lanes are not defined.</summary>
    public bool InJunction { get; init; }

    /// <summary>Lanes of the car's direction at the car; null unless the lanes are known.</summary>
    public int? LaneCount { get; init; }

    /// <summary>The car's lane, 0 the leftmost of its direction; null unless the lanes are known.</summary>
    public int? Lane { get; init; }

    /// <summary>
    /// Name of the lane on the map, or of the way through a junction, on which the car is: docs/maps.md. Null if it is on none, and in
    /// sessions of earlier versions.
    /// </summary>
    public string? LaneId { get; init; }

    /// <summary>
    /// Names of the lanes and ways that begin within 70 m ahead and that the car reaches without changing lanes, the nearest first; empty
    /// if it is on no lane, null in sessions of earlier versions.
    /// </summary>
    public IReadOnlyList<string>? LanesAhead { get; init; }

    /// <summary>Mean width of the lanes at the look-ahead point, metres; null unless the lanes are known.</summary>
    public double? LaneWidthMetres { get; init; }

    /// <summary>
    /// Width of each lane at the look-ahead point from left to right, metres; null unless the lanes are known to have different widths.
    /// </summary>
    public IReadOnlyList<double>? LaneWidthsMetres { get; init; }

    /// <summary>Where the lane width comes from; null without a road.</summary>
    public LaneWidthSource? LaneWidthSource { get; init; }

    /// <summary>How far the car is to the right of the middle of its lane, metres; null unless the lanes are known.</summary>
    public double? OffsetFromLaneCentreMetres { get; init; }

    /// <summary>How far ahead the indicators are measured, metres along the road.</summary>
    public double LookAheadMetres { get; init; }

    /// <summary>Curvature of the road at the look-ahead point, 1/metres, positive to the left; 0 if unknown.</summary>
    public double CurvaturePerMetre { get; init; }

    /// <summary>DeepDriving's fourteenth value: whether more than 60 m of straight road lie ahead.</summary>
    public bool IsFast { get; init; }

    /// <summary>The thirteen indicators at the look-ahead point, metres and radians.</summary>
    public LaneIndicators Indicators { get; init; } = LaneIndicators.Unknown;

    /// <summary>The indicators that a road of TORCS would give, with the angle at the car.</summary>
    public LaneIndicators TorcsEquivalent { get; init; } = LaneIndicators.Unknown;

    /// <summary>The thirteen indicators at the car itself, metres and radians.</summary>
    public LaneIndicators IndicatorsAtCar { get; init; } = LaneIndicators.Unknown;

    /// <summary>Vehicles ahead on the same road, nearest first; their ids are those of the objects.</summary>
    public IReadOnlyList<VehicleInLane> Vehicles { get; init; } = [];

    /// <summary>The boundaries of the lanes in the image, painted or not.</summary>
    public IReadOnlyList<LaneLineView> Boundaries { get; init; } = [];

    /// <summary>The painted markings of these boundaries in the image; null if the paint is unknown.</summary>
    public IReadOnlyList<LaneLineView>? Markings { get; init; }

    /// <summary>The lane lines in the image: the painted markings or, if the paint is unknown, the boundaries.</summary>
    public IReadOnlyList<LaneLineView> Lines => Markings ?? Boundaries;

    /// <summary>Creates the label of an observation.</summary>
    /// <param name="seen">The road and its lanes at the car.</param>
    /// <param name="source">The source of the roads.</param>
    /// <param name="boundaries">The boundaries of the lanes in the image; empty if there is no image.</param>
    /// <param name="markings">The painted markings in the image; null if the paint is unknown.</param>
    public static LanesLabel Of(
        LaneObservation seen,
        string source,
        IReadOnlyList<LaneLineView> boundaries,
        IReadOnlyList<LaneLineView>? markings
    )
    {
        if (seen is null)
        {
            throw new ArgumentNullException(nameof(seen));
        }

        bool isKnown = seen.Status == LaneStatus.Known;
        return new LanesLabel
        {
            Status = seen.Status,
            Source = source,
            Confidence = seen.Match.HasRoad ? seen.Match.Confidence : 0,
            InJunction = seen.Match.HasRoad && seen.Match.InJunction,
            LaneCount = isKnown ? seen.SectionAtCar?.LaneCount : null,
            Lane = isKnown ? seen.Match.Lane : null,
            LaneWidthMetres = isKnown ? seen.Section?.LaneWidth : null,
            LaneWidthsMetres = isKnown ? seen.Section?.LaneWidths : null,
            LaneWidthSource = seen.WidthSource,
            OffsetFromLaneCentreMetres = isKnown ? seen.Match.OffsetFromLaneCentre : null,
            LookAheadMetres = seen.LookAheadMetres,
            CurvaturePerMetre = seen.CurvaturePerMetre,
            IsFast = seen.IsFast,
            Indicators = seen.Indicators,
            TorcsEquivalent = seen.Section is { } section
                ? Geometry.Lanes.TorcsEquivalent.Of(seen.Indicators, section, seen.OffsetFromLeftEdge, seen.IndicatorsAtCar.Angle)
                : LaneIndicators.Unknown,
            IndicatorsAtCar = seen.IndicatorsAtCar,
            Vehicles = seen.Vehicles,
            Boundaries = boundaries,
            Markings = markings,
        };
    }
}
