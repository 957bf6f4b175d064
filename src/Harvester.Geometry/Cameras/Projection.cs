namespace Harvester.Geometry.Cameras;

/// <summary>The image of a point of the world.</summary>
/// <param name="U">Pixels from the left edge, continuous; 0 if the point has no pixel.</param>
/// <param name="V">Pixels from the upper edge, continuous; 0 if the point has no pixel.</param>
/// <param name="Depth">Distance along the camera's forward axis, metres; negative behind the camera.</param>
/// <param name="Outcome">Whether the point is in the image, outside it, or has no pixel.</param>
public readonly record struct Projection(double U, double V, double Depth, ProjectionOutcome Outcome)
{
    /// <summary>The pixel as a vector.</summary>
    public Vector2D Pixel => new(U, V);
}
