namespace Harvester.Geometry.Lanes;

/// <summary>What a line on a road is painted like.</summary>
/// <param name="Style">Unbroken, dashed or double.</param>
/// <param name="Colour">Its colour.</param>
/// <param name="WidthMetres">Width across the whole line, metres; of a double line with the gap between its stripes.</param>
public readonly record struct MarkingPaint(MarkingStyle Style, MarkingColour Colour, double WidthMetres);
