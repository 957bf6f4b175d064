namespace Harvester.Geometry.Cameras;

/// <summary>
/// A posed camera: Algorithm 2 of the thesis and its inverse. Pixels are continuous with the origin at the upper left corner of
/// the image; pixel (i, j) covers [i, i+1) × [j, j+1). Camera frame: x right, y forward (depth), z up, metres.
/// </summary>
public sealed record Camera
{
    /// <summary>Creates a camera with intrinsics at a pose.</summary>
    /// <param name="pose">Position and orientation in the world.</param>
    /// <param name="intrinsics">How directions map to pixels.</param>
    /// <exception cref="System.ArgumentOutOfRangeException">The position is not finite.</exception>
    /// <exception cref="System.ArgumentException">The pose's axes are the default value, which is not an orientation.</exception>
    public Camera(Pose pose, CameraIntrinsics intrinsics)
    {
        Guard.Finite(pose.Position, nameof(pose));
        Guard.Orientation(pose.Axes, nameof(pose));
        Pose = pose;
        Intrinsics = Guard.NotNull(intrinsics, nameof(intrinsics));
    }

    /// <summary>Position and orientation in the world.</summary>
    public Pose Pose { get; }

    /// <summary>How directions map to pixels.</summary>
    public CameraIntrinsics Intrinsics { get; }

    /// <summary>The image's size, pixels.</summary>
    public ImageSize Image => Intrinsics.Image;

    /// <summary>Projects a point of the world, metres.</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">The point is not finite.</exception>
    public Projection Project(Vector3D world)
    {
        Vector3D point = Pose.ToLocal(Guard.Finite(world, nameof(world)));
        if (point.Y < Intrinsics.NearClip)
        {
            return new Projection(0, 0, point.Y, ProjectionOutcome.BehindNearPlane);
        }

        Vector2D pixel = PixelOf(point);
        bool inImage = pixel.X >= 0 && pixel.Y >= 0 && pixel.X < Image.Width && pixel.Y < Image.Height;
        return new Projection(pixel.X, pixel.Y, point.Y, inImage ? ProjectionOutcome.InImage : ProjectionOutcome.OutsideImage);
    }

    /// <summary>Projects many points of the world without allocating memory.</summary>
    /// <param name="world">The points, metres.</param>
    /// <param name="projections">Receives the projection of each point at the same index; at least as long.</param>
    /// <exception cref="System.ArgumentException">The array for the results is shorter than that of the points.</exception>
    /// <exception cref="System.ArgumentOutOfRangeException">A point is not finite.</exception>
    public void ProjectAll(Vector3D[] world, Projection[] projections)
    {
        Guard.NotNull(world, nameof(world));
        if (Guard.NotNull(projections, nameof(projections)).Length < world.Length)
        {
            throw new System.ArgumentException(
                $"There are {world.Length} points, but room for {projections.Length} projections.",
                nameof(projections)
            );
        }

        int done = 0;
#if NET
        if (VectorProjector.CanProject(Intrinsics.Lens))
        {
            done = VectorProjector.Project(this, world, projections);
        }
#endif
        for (int i = done; i < world.Length; i++)
        {
            projections[i] = Project(world[i]);
        }
    }

    /// <summary>The ray from the camera's position through a pixel (continuous coordinates; it may lie outside the image).</summary>
    /// <exception cref="System.ArgumentOutOfRangeException">A coordinate is not finite.</exception>
    public Ray RayThrough(double u, double v)
    {
        Guard.Finite(u, nameof(u));
        Guard.Finite(v, nameof(v));
        var shown = new Vector2D((u - Intrinsics.Cx) / Intrinsics.Fx, (v - Intrinsics.Cy) / Intrinsics.Fy);
        Vector2D ideal = Intrinsics.Lens.Undistort(shown);
        return new Ray(Pose.Position, Pose.Axes.ToWorld(new Vector3D(ideal.X, 1, -ideal.Y)));
    }

    /// <summary>
    /// The point of the world (metres) seen at a pixel at a depth along the forward axis: the inverse of <see cref="Project"/>.
    /// </summary>
    /// <exception cref="System.ArgumentOutOfRangeException">A value is not finite, or the depth is not positive.</exception>
    public Vector3D Unproject(double u, double v, double depth)
    {
        Guard.Positive(depth, nameof(depth));
        Ray ray = RayThrough(u, v);
        return ray.At(depth / ray.Direction.Dot(Pose.Axes.Forward));
    }

    /// <summary>The pixel of a point in the camera's frame that is in front of the camera.</summary>
    internal Vector2D PixelOf(Vector3D inCamera)
    {
        Vector2D shown = Intrinsics.Lens.Distort(new Vector2D(inCamera.X / inCamera.Y, -inCamera.Z / inCamera.Y));
        return new Vector2D(Intrinsics.Cx + (Intrinsics.Fx * shown.X), Intrinsics.Cy + (Intrinsics.Fy * shown.Y));
    }
}
