using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Boxes;

/// <summary>
/// The outline of a convex body under a distorting lens. Before the lens it is the convex hull of the body's corners. Each of its sides is
/// then distorted in small pieces; it may become concave.
/// </summary>
internal static class DistortedOutline
{
    /// <summary>Number of pieces from the middle of the image to its corner: a piece deviates from its chord by about 0.01 px.</summary>
    private const int PiecesToCorner = 32;

    /// <summary>
    /// Sets the outline, in pixels, from the end points in the buffers; outside the image, pieces grow with the distance from it.
    /// </summary>
    public static void Set(ProjectorBuffers buffers, Camera camera)
    {
        buffers.Points.Clear();
        for (int i = 0; i < buffers.EndCount; i++)
        {
            Vector3D end = buffers.End(i);
            buffers.Points.Add(new Vector2D(end.X / end.Y, -end.Z / end.Y));
        }

        PointBuffer hull = buffers.Hull;
        hull.SetHullOf(buffers.Points);
        double radius = RadiusOfImage(camera.Intrinsics);
        buffers.Outline.Clear();
        for (int i = 0; i < hull.Count; i++)
        {
            AddSide(buffers.Outline, camera, hull[i], hull[(i + 1) % hull.Count], radius);
        }
    }

    /// <summary>Distance of a corner of the image from the optical axis before the lens, at depth 1.</summary>
    private static double RadiusOfImage(CameraIntrinsics intrinsics)
    {
        double x = Math.Max(intrinsics.Cx, intrinsics.Image.Width - intrinsics.Cx) / intrinsics.Fx;
        double y = Math.Max(intrinsics.Cy, intrinsics.Image.Height - intrinsics.Cy) / intrinsics.Fy;
        return intrinsics.Lens.Undistort(new Vector2D(x, y)).Length;
    }

    /// <summary>
    /// Adds a side without its end. Positions are measured from its point nearest to the axis, where the distortion curves it most.
    /// </summary>
    private static void AddSide(PointBuffer outline, Camera camera, Vector2D from, Vector2D to, double radius)
    {
        Vector2D side = to - from;
        double length = side.Length;
        Vector2D along = length > 0 ? side * (1 / length) : side;
        double first = from.Dot(along);
        Vector2D nearest = from - (along * first);
        for (double place = first; place < first + length || place == first; place += Stride(place, radius))
        {
            // place runs along the side's line from its point nearest to the axis.
            Vector2D point = nearest + (along * place);
            outline.Add(camera.PixelOf(new Vector3D(point.X, 1, -point.Y)));
        }
    }

    // Pieces of equal length in the image; outside, where only the side's course matters, half of the distance from it.
    private static double Stride(double place, double radius) => Math.Max(radius / PiecesToCorner, (Math.Abs(place) - radius) / 2);
}
