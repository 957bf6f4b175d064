using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Reports.Sessions;

/// <summary>The twelve edges of a cuboid, projected to lines in the image.</summary>
public static class CuboidEdges
{
    /// <summary>
    /// Edges that cross the near plane are cut slightly beyond it, so that rounding does not put the cut behind the plane.
    /// </summary>
    private const double BeyondNearPlane = 1 + 1e-9;

    /// <summary>The edges, clipped at the near plane; their ends may lie outside the image.</summary>
    public static IEnumerable<(Vector2D Start, Vector2D End)> Of(Camera camera, Cuboid cuboid)
    {
        double near = camera.Intrinsics.NearClip * BeyondNearPlane;
        foreach ((int start, int end) in Cuboid.Edges)
        {
            Vector3D a = cuboid.Corner(start);
            Vector3D b = cuboid.Corner(end);
            double depthA = camera.Pose.ToLocal(a).Y;
            double depthB = camera.Pose.ToLocal(b).Y;
            if (Math.Max(depthA, depthB) <= near)
            {
                continue;
            }

            Vector3D from = depthA < near ? a + ((b - a) * ((near - depthA) / (depthB - depthA))) : a;
            Vector3D to = depthB < near ? b + ((a - b) * ((near - depthB) / (depthA - depthB))) : b;
            Projection first = camera.Project(from);
            Projection second = camera.Project(to);
            if (first.Outcome != ProjectionOutcome.BehindNearPlane && second.Outcome != ProjectionOutcome.BehindNearPlane)
            {
                yield return (first.Pixel, second.Pixel);
            }
        }
    }
}
