using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Boxes;

/// <summary>
/// Algorithm 1 of the thesis, done right: the twelve edges are clipped at the near plane in the camera's frame, what is left is
/// projected, its convex hull is the silhouette, and the silhouette is cut with the image.
/// </summary>
public static class CuboidProjector
{
    /// <summary>A lens that bends lines has its extremes between an edge's ends; so many pieces bring the error well under a hundredth of a pixel.</summary>
    private const int PiecesOfBentEdge = 32;

    /// <summary>
    /// Projects a cuboid. One that contains the camera's position covers the whole image; one behind the near plane gives nothing;
    /// one that touches the image only in a line or a point is outside it.
    /// </summary>
    public static CuboidProjection Project(Camera camera, Cuboid cuboid) =>
        Project(camera, cuboid, Guard.NotNull(cuboid, nameof(cuboid)).EdgesInWorld);

    /// <summary>Projects a convex body within a cuboid in the same way.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The cuboid around the body.</param>
    /// <param name="edges">The body's edges, in the world.</param>
    public static CuboidProjection Project(Camera camera, Cuboid cuboid, IEnumerable<(Vector3D Start, Vector3D End)> edges)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        Guard.NotNull(edges, nameof(edges));
        Box2D image = camera.Image.Bounds;
        List<Vector2D> points = VisibleEdgePoints(camera, edges);
        if (cuboid.Contains(camera.Pose.Position))
        {
            points.Add(new Vector2D(image.XMin, image.YMin));
            points.Add(new Vector2D(image.XMax, image.YMin));
            points.Add(new Vector2D(image.XMax, image.YMax));
            points.Add(new Vector2D(image.XMin, image.YMax));
        }

        if (points.Count == 0)
        {
            return new CuboidProjection(BoxOutcome.BehindNearPlane, null, null, 0, points);
        }

        IReadOnlyList<Vector2D> silhouette = ConvexPolygon.Hull(points);
        IReadOnlyList<Vector2D> inImage = ConvexPolygon.Clip(silhouette, image);
        Box2D? amodal = ConvexPolygon.Bounds(silhouette);
        double area = ConvexPolygon.Area(silhouette);
        double areaInImage = ConvexPolygon.Area(inImage);
        if (!(areaInImage > 0))
        {
            return new CuboidProjection(BoxOutcome.OutsideImage, null, amodal, 1, silhouette);
        }

        // Clipping computes points on the image's border with rounding; the box is held to the image exactly.
        Box2D? box = ConvexPolygon.Bounds(inImage)?.Intersect(image);
        double truncated = Math.Min(1, Math.Max(0, 1 - (areaInImage / area)));
        return box is null
            ? new CuboidProjection(BoxOutcome.OutsideImage, null, amodal, 1, silhouette)
            : new CuboidProjection(BoxOutcome.InImage, box, amodal?.Union(box.Value), truncated, silhouette);
    }

    private static List<Vector2D> VisibleEdgePoints(Camera camera, IEnumerable<(Vector3D Start, Vector3D End)> edges)
    {
        double near = camera.Intrinsics.NearClip;
        int pieces = camera.Intrinsics.Lens.IsRectilinear ? 1 : PiecesOfBentEdge;
        var points = new List<Vector2D>();
        foreach ((Vector3D start, Vector3D end) in edges)
        {
            Vector3D a = camera.Pose.ToLocal(start);
            Vector3D b = camera.Pose.ToLocal(end);
            if (a.Y < near && b.Y < near)
            {
                continue;
            }

            Vector3D from = a.Y < near ? AtNearPlane(b, a, near) : a;
            Vector3D to = b.Y < near ? AtNearPlane(a, b, near) : b;
            for (int piece = 0; piece <= pieces; piece++)
            {
                points.Add(camera.PixelOf(from + ((to - from) * ((double)piece / pieces))));
            }
        }

        return points;
    }

    private static Vector3D AtNearPlane(Vector3D front, Vector3D behind, double near)
    {
        Vector3D crossing = front + ((behind - front) * ((front.Y - near) / (front.Y - behind.Y)));
        return crossing with { Y = near };
    }
}
