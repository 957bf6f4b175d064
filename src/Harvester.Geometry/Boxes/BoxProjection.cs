namespace Harvester.Geometry.Boxes;

/// <summary>The boxes of a cuboid in the image, without its silhouette; a value type, so that none is allocated.</summary>
/// <param name="Outcome">Whether a part of the cuboid is in the image.</param>
/// <param name="Box">The box around the part of the silhouette in the image, pixels; null unless the outcome is in the image.</param>
/// <param name="AmodalBox">The box around the whole silhouette, pixels; null behind the near plane.</param>
/// <param name="TruncatedFraction">The fraction of the silhouette's area outside the image, 0 to 1; 1 if none of it is in
/// the image.</param>
public readonly record struct BoxProjection(BoxOutcome Outcome, Box2D? Box, Box2D? AmodalBox, double TruncatedFraction);
