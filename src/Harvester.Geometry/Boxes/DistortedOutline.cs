using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Boxes;

/// <summary>
/// The outline of a convex body under a lens that bends lines. Before the lens it is the convex hull of the body's corners; each of
/// its sides is then bent in small pieces, and may bend inwards.
/// </summary>
internal static class DistortedOutline
{
    /// <summary>Pieces from the middle of the image to its corner: a piece bulges by about a hundredth of a pixel.</summary>
    private const int PiecesToCorner = 32;

    /// <summary>The outline in pixels; within the image as fine as said, coarser with the distance from it.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="corners">Corners of the body in the camera's frame, all in front of it.</param>
    public static IReadOnlyList<Vector2D> Of(Camera camera, List<Vector3D> corners)
    {
        IReadOnlyList<Vector2D> hull = ConvexPolygon.Hull(
            corners.ConvertAll(corner => new Vector2D(corner.X / corner.Y, -corner.Z / corner.Y)));
        double radius = RadiusOfImage(camera.Intrinsics);
        var outline = new List<Vector2D>();
        for (int i = 0; i < hull.Count; i++)
        {
            AddSide(outline, camera, hull[i], hull[(i + 1) % hull.Count], radius);
        }

        return outline;
    }

    /// <summary>How far from the optical axis a corner of the image is before the lens, at depth 1.</summary>
    private static double RadiusOfImage(CameraIntrinsics intrinsics)
    {
        double x = Math.Max(intrinsics.Cx, intrinsics.Image.Width - intrinsics.Cx) / intrinsics.Fx;
        double y = Math.Max(intrinsics.Cy, intrinsics.Image.Height - intrinsics.Cy) / intrinsics.Fy;
        return intrinsics.Lens.Undistort(new Vector2D(x, y)).Length;
    }

    /// <summary>
    /// Adds a side without its end. Places on it are counted from its point nearest to the axis, about which it is bent most.
    /// </summary>
    private static void AddSide(List<Vector2D> outline, Camera camera, Vector2D from, Vector2D to, double radius)
    {
        Vector2D side = to - from;
        double length = side.Length;
        Vector2D along = length > 0 ? side * (1 / length) : side;
        double first = from.Dot(along);
        Vector2D nearest = from - (along * first);
        for (double place = first; place < first + length || place == first; place += Stride(place, radius))
        {
            Vector2D point = nearest + (along * place);
            outline.Add(camera.PixelOf(new Vector3D(point.X, 1, -point.Y)));
        }
    }

    private static double Stride(double place, double radius) =>
        Math.Max(radius / PiecesToCorner, (Math.Abs(place) - radius) / 2);
}
