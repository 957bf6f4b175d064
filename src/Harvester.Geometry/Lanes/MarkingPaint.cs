namespace Harvester.Geometry.Lanes;

/// <summary>How a line on a road is painted.</summary>
/// <param name="Style">Unbroken, dashed or double.</param>
/// <param name="Colour">Its colour.</param>
/// <param name="WidthMetres">Width of the whole line, metres; for a double line including the gap between its stripes.</param>
public readonly record struct MarkingPaint(MarkingStyle Style, MarkingColour Colour, double WidthMetres);
