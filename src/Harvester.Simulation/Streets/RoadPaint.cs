using Harvester.Geometry.Lanes;

namespace Harvester.Simulation.Streets;

/// <summary>How the lines of a road are painted. Lengths are metres.</summary>
internal sealed record RoadPaint
{
    /// <summary>The paint of ordinary roads.</summary>
    public static RoadPaint Usual { get; } = new();

    /// <summary>Width of a stripe.</summary>
    public double StripeWidth { get; init; } = 0.15;

    /// <summary>Distance of the middles of the stripes of a double line.</summary>
    public double BetweenStripes { get; init; } = 0.3;

    public double DashLength { get; init; } = 3;

    public double DashPeriod { get; init; } = 9;

    /// <summary>Distance of an edge line from the edge of the carriageway: a shoulder, if it is wide.</summary>
    public double EdgeInset { get; init; } = 0.25;

    /// <summary>Whether the edges of the carriageway are painted.</summary>
    public bool HasEdges { get; init; } = true;

    /// <summary>Whether the left edge of a one-way road is yellow.</summary>
    public bool HasYellowLeftEdge { get; init; }

    /// <summary>Length of the arrows on lanes before junctions; 0 for none.</summary>
    public double ArrowLength { get; init; }

    /// <summary>How the line between the directions of a road without median is painted; null for the usual one of its lanes.</summary>
    public MarkingStyle? Centre { get; init; }
}
