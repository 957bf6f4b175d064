using System.Collections.Generic;
using Harvester.Geometry;

namespace Harvester.Evaluation.Reports;

/// <summary>A line of a plot.</summary>
/// <param name="Style">Its class in the page's style sheet.</param>
/// <param name="Points">Its points, in the plot's units.</param>
internal sealed record PlotLine(string Style, IReadOnlyList<Vector2D> Points);
