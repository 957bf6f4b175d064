namespace Harvester.Geometry.Calibration;

/// <summary>A ball to be drawn in the world, and where it should be seen.</summary>
/// <param name="Centre">Its centre, metres, world.</param>
/// <param name="RadiusMetres">Its radius; the farther, the larger, so that all look alike in the picture.</param>
/// <param name="ExpectedPixel">Where the camera that planned it would see the centre.</param>
public readonly record struct PlannedMarker(Vector3D Centre, double RadiusMetres, Vector2D ExpectedPixel)
{
    /// <summary>
    /// The point whose image is the centre of the ball's image. A ball at (X, Y) and depth Z shows as an ellipse about (X, Y) Z / (Z² - R²)
    /// in normalised coordinates, which is the image of the point at the depth Z - R² / Z: farther from the axis than the image of the
    /// ball's own centre.
    /// </summary>
    /// <param name="camera">The camera's pose.</param>
    public Vector3D CentreOfImage(Pose camera)
    {
        Vector3D local = camera.ToLocal(Centre);
        return camera.ToWorld(new Vector3D(local.X, local.Y - (RadiusMetres * RadiusMetres / local.Y), local.Z));
    }
}
