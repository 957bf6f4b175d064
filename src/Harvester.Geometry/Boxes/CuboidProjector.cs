using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Boxes;

/// <summary>
/// Algorithm 1 of the thesis with near-plane clipping: the twelve edges are clipped at the near plane in the camera's frame, the remaining
/// parts are projected, their convex hull is the outline, and the outline is clipped to the image. A distorting lens is applied to the
/// outline after the hull is taken, because the outline of a convex body is convex only before distortion.
/// </summary>
public static class CuboidProjector
{
    /// <summary>
    /// Projects a cuboid. One that contains the camera's position covers the whole image; one that touches the image only in a line or a
    /// point is outside it.
    /// </summary>
    public static CuboidProjection Project(Camera camera, Cuboid cuboid)
    {
        Guard.NotNull(camera, nameof(camera));
        ProjectorBuffers buffers = ProjectorBuffers.OfThread;
        AddEnds(buffers, camera, Guard.NotNull(cuboid, nameof(cuboid)));
        return WithSilhouette(buffers, camera, BoxesOf(buffers, camera, cuboid));
    }

    /// <summary>Projects a convex body within a cuboid in the same way.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="cuboid">The cuboid around the body.</param>
    /// <param name="edges">The body's edges, in the world.</param>
    public static CuboidProjection Project(Camera camera, Cuboid cuboid, IEnumerable<(Vector3D Start, Vector3D End)> edges)
    {
        Guard.NotNull(camera, nameof(camera));
        Guard.NotNull(cuboid, nameof(cuboid));
        ProjectorBuffers buffers = ProjectorBuffers.OfThread;
        buffers.ClearEnds();
        foreach ((Vector3D start, Vector3D end) in Guard.NotNull(edges, nameof(edges)))
        {
            AddEdge(buffers, camera.Intrinsics.NearClip, camera.Pose.ToLocal(start), camera.Pose.ToLocal(end));
        }

        return WithSilhouette(buffers, camera, BoxesOf(buffers, camera, cuboid));
    }

    /// <summary>The boxes of <see cref="Project(Camera, Cuboid)"/> without the silhouette; nothing is allocated.</summary>
    public static BoxProjection BoxesOf(Camera camera, Cuboid cuboid)
    {
        Guard.NotNull(camera, nameof(camera));
        ProjectorBuffers buffers = ProjectorBuffers.OfThread;
        AddEnds(buffers, camera, Guard.NotNull(cuboid, nameof(cuboid)));
        return BoxesOf(buffers, camera, cuboid);
    }

    /// <summary>The boxes around the end points in the buffers; also sets the outline there.</summary>
    private static BoxProjection BoxesOf(ProjectorBuffers buffers, Camera camera, Cuboid cuboid)
    {
        Box2D image = camera.Image.Bounds;
        bool isAround = cuboid.Contains(camera.Pose.Position);
        PointBuffer outline = buffers.Outline;
        if (buffers.EndCount == 0 && !isAround)
        {
            outline.Clear();
            return new BoxProjection(BoxOutcome.BehindNearPlane, null, null, 1);
        }

        SetOutline(buffers, camera);

        // A camera inside the cuboid sees it everywhere; the outline of the part in front of it need not reach the image's corners.
        if (isAround)
        {
            outline.Add(new Vector2D(image.XMin, image.YMin));
            outline.Add(new Vector2D(image.XMax, image.YMin));
            outline.Add(new Vector2D(image.XMax, image.YMax));
            outline.Add(new Vector2D(image.XMin, image.YMax));
            BecomeHull(buffers);
        }

        Box2D? amodal = outline.Bounds();
        PointBuffer inImage = outline;
        if (!outline.IsWithin(image))
        {
            inImage = buffers.InImage;
            inImage.SetClipped(outline, image, buffers.Hull);
        }

        // Truncated fraction = 1 - area in the image / area of the whole outline.
        double area = outline.Area();
        double areaInImage = inImage.Area();

        // Clipping computes points on the image's border with rounding; the box is clamped to the image.
        Box2D? box = areaInImage > 0 ? inImage.Bounds()?.Intersect(image) : null;
        double truncated = Math.Min(1, Math.Max(0, 1 - (areaInImage / area)));
        return box is null
            ? new BoxProjection(BoxOutcome.OutsideImage, null, amodal, 1)
            : new BoxProjection(BoxOutcome.InImage, box, amodal?.Union(box.Value), truncated);
    }

    private static CuboidProjection WithSilhouette(ProjectorBuffers buffers, Camera camera, BoxProjection boxes)
    {
        if (!camera.Intrinsics.Lens.IsRectilinear)
        {
            BecomeHull(buffers);
        }

        return new CuboidProjection(boxes.Outcome, boxes.Box, boxes.AmodalBox, boxes.TruncatedFraction, buffers.Outline.ToArray());
    }

    private static void SetOutline(ProjectorBuffers buffers, Camera camera)
    {
        if (!camera.Intrinsics.Lens.IsRectilinear)
        {
            DistortedOutline.Set(buffers, camera);
            return;
        }

        buffers.Points.Clear();
        for (int i = 0; i < buffers.EndCount; i++)
        {
            buffers.Points.Add(camera.PixelOf(buffers.End(i)));
        }

        buffers.Outline.SetHullOf(buffers.Points);
    }

    /// <summary>Replaces the outline by its convex hull.</summary>
    private static void BecomeHull(ProjectorBuffers buffers)
    {
        buffers.Points.Clear();
        for (int i = 0; i < buffers.Outline.Count; i++)
        {
            buffers.Points.Add(buffers.Outline[i]);
        }

        buffers.Outline.SetHullOf(buffers.Points);
    }

    /// <summary>
    /// Adds the end points of the parts of a cuboid's edges in front of the near plane, in the camera's frame; each corner once if the near
    /// plane cuts none.
    /// </summary>
    private static void AddEnds(ProjectorBuffers buffers, Camera camera, Cuboid cuboid)
    {
        double near = camera.Intrinsics.NearClip;
        bool isCut = false;
        for (int number = 0; number < Cuboid.CornerCount; number++)
        {
            buffers.Corners[number] = camera.Pose.ToLocal(cuboid.Corner(number));
            isCut |= buffers.Corners[number].Y < near;
        }

        buffers.ClearEnds();
        if (!isCut)
        {
            foreach (Vector3D corner in buffers.Corners)
            {
                buffers.AddEnd(corner);
            }

            return;
        }

        for (int edge = 0; edge < Cuboid.EdgeCount; edge++)
        {
            (int start, int end) = Cuboid.Edge(edge);
            AddEdge(buffers, near, buffers.Corners[start], buffers.Corners[end]);
        }
    }

    private static void AddEdge(ProjectorBuffers buffers, double near, Vector3D a, Vector3D b)
    {
        if (a.Y >= near || b.Y >= near)
        {
            buffers.AddEnd(a.Y < near ? AtNearPlane(b, a, near) : a);
            buffers.AddEnd(b.Y < near ? AtNearPlane(a, b, near) : b);
        }
    }

    private static Vector3D AtNearPlane(Vector3D front, Vector3D behind, double near)
    {
        // Depth falls linearly along the edge: front + t·(behind - front) is at the near plane for t = (front.Y - near) / (front.Y -
        // behind.Y).
        Vector3D crossing = front + ((behind - front) * ((front.Y - near) / (front.Y - behind.Y)));
        return crossing with { Y = near };
    }
}
