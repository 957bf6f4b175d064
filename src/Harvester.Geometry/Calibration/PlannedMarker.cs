namespace Harvester.Geometry.Calibration;

/// <summary>A ball to be drawn in the world, and where it is expected in the image.</summary>
/// <param name="Centre">Its centre, metres, world.</param>
/// <param name="RadiusMetres">Its radius, metres; it grows with the distance, so that all balls look equally large.</param>
/// <param name="ExpectedPixel">Where the planning camera would see the centre, pixels.</param>
public readonly record struct PlannedMarker(Vector3D Centre, double RadiusMetres, Vector2D ExpectedPixel)
{
    /// <summary>
    /// The point that projects to the centre of the ball's image. A ball at (X, Y) and depth Z appears as an ellipse about (X, Y) Z / (Z² -
    /// R²) in normalised coordinates. That is the image of the point at depth Z - R² / Z, farther from the axis than the image of the
    /// ball's own centre.
    /// </summary>
    /// <param name="camera">The camera's pose.</param>
    public Vector3D CentreOfImage(Pose camera)
    {
        Vector3D local = camera.ToLocal(Centre);
        return camera.ToWorld(new Vector3D(local.X, local.Y - (RadiusMetres * RadiusMetres / local.Y), local.Z));
    }
}
