using System.Runtime.Intrinsics;

namespace Harvester.Simulation.Rendering;

/// <summary>Where a box lies on the screen, for passing over what cannot be seen; never too small.</summary>
/// <param name="Pixels">The pixels whose centres it may cover.</param>
/// <param name="Nearness">The near plane's distance divided by the least depth.</param>
internal readonly record struct ScreenBox(PixelRectangle Pixels, double Nearness)
{
    private const int DepthElement = 3;

    /// <summary>Room for the rounding of corners, pixels.</summary>
    private static readonly Vector256<double> Room = Vector256.Create(1e-6, 1e-6, 0, 0);

    /// <summary>Projects a box; null where it reaches in front of the near plane, so that nothing can be said of it.</summary>
    public static ScreenBox? Of(in Bounds box, in ClipTransform toClip, View view)
    {
        Vector256<double> corner = toClip.Apply(box.Min);
        Vector256<double> along = toClip.AlongX(box.Max.X - box.Min.X);
        Vector256<double> across = toClip.AlongY(box.Max.Y - box.Min.Y);
        Vector256<double> up = toClip.AlongZ(box.Max.Z - box.Min.Z);
        double depth =
            corner[DepthElement] + Math.Min(0, along[DepthElement]) + Math.Min(0, across[DepthElement]) + Math.Min(0, up[DepthElement]);
        if (!(depth > view.NearClip))
        {
            return null;
        }

        Vector256<double> min = Vector256.Create(double.PositiveInfinity);
        Vector256<double> max = Vector256.Create(double.NegativeInfinity);
        Include(corner, ref min, ref max);
        Include(corner + along, ref min, ref max);
        Include(corner + across, ref min, ref max);
        Include(corner + along + across, ref min, ref max);
        corner += up;
        Include(corner, ref min, ref max);
        Include(corner + along, ref min, ref max);
        Include(corner + across, ref min, ref max);
        Include(corner + along + across, ref min, ref max);
        return new ScreenBox(view.PixelsIn(min - Room, max + Room), view.NearClip / depth);
    }

    private static void Include(Vector256<double> corner, ref Vector256<double> min, ref Vector256<double> max)
    {
        Vector256<double> onScreen = corner / Vector256.Create(corner[DepthElement]);
        min = Vector256.MinNative(min, onScreen);
        max = Vector256.MaxNative(max, onScreen);
    }
}
