using Harvester.Geometry;

namespace Harvester.Pages.Plots;

/// <summary>A ring around a point of a plot.</summary>
/// <param name="Style">Its class in the style sheet.</param>
/// <param name="Place">Its centre, in the units of the axes.</param>
/// <param name="Label">Text that appears when the pointer is on it.</param>
public sealed record PlotMark(string Style, Vector2D Place, string Label);
