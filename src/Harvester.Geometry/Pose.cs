namespace Harvester.Geometry;

/// <summary>Position and orientation: the rigid transform from a frame of its own (x right, y forward, z up) to the world.</summary>
/// <param name="Position">Origin of the frame in the world, metres.</param>
/// <param name="Axes">Orientation of the frame.</param>
public readonly record struct Pose(Vector3D Position, Axes Axes)
{
    /// <summary>Transforms a point of this frame to the world.</summary>
    public Vector3D ToWorld(Vector3D local) => Position + Axes.ToWorld(local);

    /// <summary>Transforms a point of the world to this frame.</summary>
    public Vector3D ToLocal(Vector3D world) => Axes.ToLocal(world - Position);

    /// <summary>Transforms a pose in this frame to the world, for example that of a camera mounted on a car.</summary>
    public Pose Compose(Pose local) =>
        new(
            ToWorld(local.Position),
            Axes.FromVectors(Axes.ToWorld(local.Axes.Right), Axes.ToWorld(local.Axes.Forward), Axes.ToWorld(local.Axes.Up))
        );
}
