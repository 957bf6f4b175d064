using Harvester.Sessions.Labels;

namespace Harvester.Exports;

/// <summary>Measures how far a lens shifts points of an image from their pinhole positions.</summary>
internal static class LensDistortion
{
    /// <summary>Shift below which formats for pinhole cameras accept a lens, pixels: boxes are not more accurate than this.</summary>
    public const double MaxPixels = 1;

    private const int Radii = 32;

    /// <summary>The largest shift between the centre of the image and its corners, pixels.</summary>
    public static double PixelsOf(CameraLabel camera)
    {
        (_, double k1, double k2) = camera.Distortion;
        double corner = Math.Sqrt(Square(camera.Width / 2.0 / camera.Fx) + Square(camera.Height / 2.0 / camera.Fy));
        return Math.Max(camera.Fx, camera.Fy) * Enumerable.Range(1, Radii).Max(i => Shift(corner * i / Radii));

        double Shift(double radius) => Math.Abs(radius * ((k1 * Square(radius)) + (k2 * Square(Square(radius)))));
    }

    private static double Square(double value) => value * value;
}
