using System;
using System.Collections.Generic;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Boxes;

/// <summary>
/// Algorithm 1 of the thesis, done right: the twelve edges are clipped at the near plane in the camera's frame, what is left is
/// projected, its convex hull is the outline, and the outline is cut with the image. A lens that bends lines bends the outline after
/// the hull is taken, for it is only before the lens that the outline of a convex body is convex.
/// </summary>
public static class CuboidProjector
{
    /// <summary>
    /// Projects a cuboid. One that contains the camera's position covers the whole image; one behind the near plane gives nothing;
    /// one that touches the image only in a line or a point is outside it.
    /// </summary>
    public static CuboidProjection Project(Camera camera, Cuboid cuboid)
    {
        Guard.NotNull(camera, nameof(camera));
        return Project(camera, cuboid, VisibleEdgeEnds(camera, Guard.NotNull(cuboid, nameof(cuboid))));
    }

    /// <summary>Projects a convex body within a cuboid in the same way.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The cuboid around the body.</param>
    /// <param name="edges">The body's edges, in the world.</param>
    public static CuboidProjection Project(Camera camera, Cuboid cuboid, IEnumerable<(Vector3D Start, Vector3D End)> edges)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        return Project(camera, cuboid, VisibleEdgeEnds(camera, Guard.NotNull(edges, nameof(edges))));
    }

    private static CuboidProjection Project(Camera camera, Cuboid cuboid, List<Vector3D> ends)
    {
        Box2D image = camera.Image.Bounds;
        bool isAround = cuboid.Contains(camera.Pose.Position);
        if (ends.Count == 0 && !isAround)
        {
            return new CuboidProjection(BoxOutcome.BehindNearPlane, null, null, 0, []);
        }

        IReadOnlyList<Vector2D> outline = camera.Intrinsics.Lens.IsRectilinear
            ? ConvexPolygon.Hull(ends.ConvertAll(camera.PixelOf))
            : DistortedOutline.Of(camera, ends);
        if (isAround)
        {
            outline = ConvexPolygon.Hull(
            [
                .. outline, new(image.XMin, image.YMin), new(image.XMax, image.YMin), new(image.XMax, image.YMax),
                    new(image.XMin, image.YMax),
            ]);
        }

        IReadOnlyList<Vector2D> silhouette = camera.Intrinsics.Lens.IsRectilinear ? outline : ConvexPolygon.Hull(outline);
        IReadOnlyList<Vector2D> inImage = ConvexPolygon.Clip(outline, image);
        Box2D? amodal = ConvexPolygon.Bounds(outline);
        double area = ConvexPolygon.Area(outline);
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

    /// <summary>The ends of what the near plane leaves of a cuboid's edges, in the camera's frame, each point once.</summary>
    private static List<Vector3D> VisibleEdgeEnds(Camera camera, Cuboid cuboid)
    {
        double near = camera.Intrinsics.NearClip;
        var ends = new List<Vector3D>(Cuboid.CornerCount);
        bool isCut = false;
        for (int number = 0; number < Cuboid.CornerCount; number++)
        {
            Vector3D corner = camera.Pose.ToLocal(cuboid.Corner(number));
            isCut |= corner.Y < near;
            ends.Add(corner);
        }

        // Hardly any cuboid reaches through the near plane.
        return isCut ? VisibleEdgeEnds(camera, cuboid.EdgesInWorld) : ends;
    }

    /// <summary>The ends of what the near plane leaves of edges, in the camera's frame.</summary>
    private static List<Vector3D> VisibleEdgeEnds(Camera camera, IEnumerable<(Vector3D Start, Vector3D End)> edges)
    {
        double near = camera.Intrinsics.NearClip;
        var ends = new List<Vector3D>();
        foreach ((Vector3D start, Vector3D end) in edges)
        {
            Vector3D a = camera.Pose.ToLocal(start);
            Vector3D b = camera.Pose.ToLocal(end);
            if (a.Y >= near || b.Y >= near)
            {
                ends.Add(a.Y < near ? AtNearPlane(b, a, near) : a);
                ends.Add(b.Y < near ? AtNearPlane(a, b, near) : b);
            }
        }

        return ends;
    }

    private static Vector3D AtNearPlane(Vector3D front, Vector3D behind, double near)
    {
        Vector3D crossing = front + ((behind - front) * ((front.Y - near) / (front.Y - behind.Y)));
        return crossing with { Y = near };
    }
}
