using Harvester.Geometry;

namespace Harvester.Pages.Plots;

/// <summary>A line of a plot.</summary>
/// <param name="Style">Class in the style sheet.</param>
/// <param name="Points">The points, in the units of the axes.</param>
public sealed record PlotLine(string Style, IReadOnlyList<Vector2D> Points);
