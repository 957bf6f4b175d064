using System;
using System.Linq;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Exports;

/// <summary>How far a lens moves points of an image from where a pinhole camera shows them.</summary>
internal static class LensDistortion
{
    /// <summary>What a format for pinhole cameras leaves out without harm, pixels: the boxes are no closer to their objects.</summary>
    public const double MaxPixels = 1;

    private const int Radii = 32;

    /// <summary>The largest shift between the image's centre and its corners, pixels.</summary>
    public static double PixelsOf(CameraLabel camera)
    {
        (_, double k1, double k2) = camera.Distortion;
        double corner = Math.Sqrt(Square(camera.Width / 2.0 / camera.Fx) + Square(camera.Height / 2.0 / camera.Fy));
        return Math.Max(camera.Fx, camera.Fy) * Enumerable.Range(1, Radii).Max(i => Shift(corner * i / Radii));

        double Shift(double radius) => Math.Abs(radius * ((k1 * Square(radius)) + (k2 * Square(Square(radius)))));
    }

    private static double Square(double value) => value * value;
}
