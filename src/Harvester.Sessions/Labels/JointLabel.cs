using Harvester.Geometry;

namespace Harvester.Sessions.Labels;

/// <summary>A joint of a person in an image.</summary>
/// <param name="Position">Metres, world.</param>
/// <param name="Pixel">Its position in the image, pixels; it may be outside the image. Null nearer than the near plane.</param>
/// <param name="Visibility">Whether it is visible.</param>
public sealed record JointLabel(Vector3D Position, Vector2D? Pixel, JointVisibility Visibility);
