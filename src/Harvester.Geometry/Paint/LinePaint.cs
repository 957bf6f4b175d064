using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Paint;

/// <summary>
/// A line measured on a stretch of a link. Stations are arc lengths on the ground along the link's <see cref="Roads.RoadCurve"/>, metres
/// from its start. Offsets are metres to the right of that curve, looking from its start to its end; between the two stations the offset
/// changes linearly.
/// </summary>
/// <param name="FromStation">Where the stretch begins; 0 or more.</param>
/// <param name="ToStation">Where the stretch ends; greater than <paramref name="FromStation"/>, at most the link's length.</param>
/// <param name="FromOffset">Offset of the line's middle at <paramref name="FromStation"/>.</param>
/// <param name="ToOffset">Offset of the line's middle at <paramref name="ToStation"/>.</param>
/// <param name="Paint">Style, colour and width.</param>
public sealed record LinePaint(double FromStation, double ToStation, double FromOffset, double ToOffset, MarkingPaint Paint)
{
    /// <summary>The dashes of a dashed line; null for other lines, and if their pattern is unknown.</summary>
    public DashPattern? Dashes { get; init; }

    /// <summary>Standard deviation of the offsets, metres; greater than 0.</summary>
    public required double SigmaMetres { get; init; }

    /// <summary>Number of images that show the line; at least 1.</summary>
    public required int Images { get; init; }

    /// <summary>Offset of the line's middle at a station, metres to the right of the curve; extrapolated beyond the stretch.</summary>
    public double OffsetAt(double station) => FromOffset + ((ToOffset - FromOffset) * (station - FromStation) / (ToStation - FromStation));
}
