using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Calibration;

/// <summary>
/// The lens as linear equations. With x, y the ideal normalised image point, q = x² + y², and s the focal scale, a pixel is u = W/2 + W·ox
/// + fx·x·(s + s·k1·q + s·k2·q²) and v = H/2 + H·oy + fy·y·(s + s·k1·q + s·k2·q²), linear in the parameters s, ox, oy, s·k1, s·k2.
/// </summary>
internal sealed class LensEquations(CameraIntrinsics ideal)
{
    public const int ParameterCount = 5;

    public static Lens LensOf(double[] parameters) =>
        new(parameters[0], parameters[1], parameters[2], parameters[3] / parameters[0], parameters[4] / parameters[0]);

    /// <summary>The ideal normalised image point of a sighting: x right, y down, at depth 1.</summary>
    public static Vector2D PointOf(Sighting sighting)
    {
        Vector3D local = sighting.CameraPose.ToLocal(sighting.World);
        return new Vector2D(local.X / local.Y, -local.Z / local.Y);
    }

    public double[] RowU(Vector2D point) => Row(ideal.Fx * point.X, ideal.Image.Width, 0, point);

    public double[] RowV(Vector2D point) => Row(ideal.Fy * point.Y, 0, ideal.Image.Height, point);

    public double TargetU(Vector2D pixel) => pixel.X - ideal.Cx;

    public double TargetV(Vector2D pixel) => pixel.Y - ideal.Cy;

    private static double[] Row(double focal, double offsetX, double offsetY, Vector2D point)
    {
        // Derivatives of the pixel by s, ox, oy, s·k1 and s·k2.
        double q = point.Dot(point);
        return [focal, offsetX, offsetY, focal * q, focal * q * q];
    }
}
