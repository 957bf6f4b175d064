namespace Harvester.Geometry.Boxes;

/// <summary>The image of a cuboid: its silhouette and the boxes around it.</summary>
/// <param name="Outcome">Where the cuboid lies for the camera.</param>
/// <param name="Box">The box around the part of the silhouette inside the image; null unless the outcome is in the image.</param>
/// <param name="AmodalBox">The box around the whole silhouette, inside and outside the image; null behind the near plane.</param>
/// <param name="TruncatedFraction">The fraction of the silhouette's area outside the image, 0 to 1; 1 if none of it is in
/// the image.</param>
/// <param name="Silhouette">
/// The outline of the whole silhouette, a convex polygon in pixels; empty behind the near plane. Where distortion makes the outline
/// concave, this is its convex hull; boxes and fraction are those of the distorted outline.
/// </param>
public sealed record CuboidProjection(
    BoxOutcome Outcome,
    Box2D? Box,
    Box2D? AmodalBox,
    double TruncatedFraction,
    IReadOnlyList<Vector2D> Silhouette
);
