using Harvester.Geometry;

namespace Harvester.Pages.Plots;

/// <summary>A ring around a point of a plot.</summary>
/// <param name="Style">Class in the style sheet.</param>
/// <param name="Place">The centre, in the units of the axes.</param>
/// <param name="Label">Tooltip of the ring.</param>
public sealed record PlotMark(string Style, Vector2D Place, string Label);
