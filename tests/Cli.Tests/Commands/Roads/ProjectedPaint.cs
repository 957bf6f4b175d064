using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Sessions.Labels;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// The true paint of a simulated game in one image: the middles of its painted lines, projected by the pinhole of the label's camera.
/// </summary>
internal sealed class ProjectedPaint
{
    /// <summary>Paint is judged up to this depth, metres.</summary>
    private const double Furthest = 50;

    /// <summary>What is nearer is below the image, metres.</summary>
    private const double MinDepth = 1;

    private readonly List<(Vector2D From, Vector2D To, double Depth)> _segments = [];

    public ProjectedPaint(IEnumerable<PaintedLine> painted, CameraLabel camera)
    {
        foreach (PaintedLine line in painted)
        {
            for (int i = 0; i + 1 < line.Points.Count; i++)
            {
                Vector3D from = camera.Pose.ToLocal(line.Points[i].World);
                Vector3D to = camera.Pose.ToLocal(line.Points[i + 1].World);
                if (Math.Max(from.Y, to.Y) > MinDepth && from.Y < 2 * Furthest)
                {
                    (from, to) = (Clipped(from, to), Clipped(to, from));
                    _segments.Add((Pixel(camera, from), Pixel(camera, to), (from.Y + to.Y) / 2));
                }
            }
        }
    }

    /// <summary>
    /// Distance of a pixel from the nearest paint, pixels, and depth of the latter, metres; null if that is farther than 50 m from the
    /// camera.
    /// </summary>
    public (double Pixels, double Depth)? Nearest(Vector2D pixel)
    {
        double least = double.PositiveInfinity;
        double depth = double.PositiveInfinity;
        foreach ((Vector2D from, Vector2D to, double at) in _segments)
        {
            Vector2D along = to - from;
            double part = Math.Clamp((pixel - from).Dot(along) / along.Dot(along), 0, 1);
            double distance = (pixel - from - (along * part)).Length;
            if (distance < least)
            {
                (least, depth) = (distance, at);
            }
        }

        return depth <= Furthest ? (least, depth) : null;
    }

    /// <summary>An end of a segment, or where the segment comes as near as is visible.</summary>
    private static Vector3D Clipped(Vector3D end, Vector3D other) =>
        end.Y >= MinDepth ? end : end + ((other - end) * ((MinDepth - end.Y) / (other.Y - end.Y)));

    private static Vector2D Pixel(CameraLabel camera, Vector3D local) =>
        new(camera.Cx + (camera.Fx * local.X / local.Y), camera.Cy - (camera.Fy * local.Z / local.Y));
}
