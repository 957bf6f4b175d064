using System.Collections.Generic;

namespace Harvester.Geometry.Boxes;

/// <summary>The image of a cuboid: its silhouette and the boxes around it.</summary>
/// <param name="Outcome">Whether there is anything of it in the image.</param>
/// <param name="Box">The box around the part of the silhouette in the image; null unless the outcome is in the image.</param>
/// <param name="AmodalBox">The box around the whole silhouette, in or outside the image; null behind the near plane.</param>
/// <param name="TruncatedFraction">The share of the silhouette's area outside the image, 0 to 1.</param>
/// <param name="Silhouette">
/// The outline of the whole silhouette, a convex polygon in pixels; empty behind the near plane. Where a lens bends it inwards, this is
/// the convex hull; boxes and fraction are those of the bent outline.
/// </param>
public sealed record CuboidProjection(
    BoxOutcome Outcome, Box2D? Box, Box2D? AmodalBox, double TruncatedFraction, IReadOnlyList<Vector2D> Silhouette);
