namespace Harvester.Geometry;

/// <summary>
/// Where something is and how it is turned: the rigid motion from its own frame (x right, y forward, z up) to the world's.
/// </summary>
/// <param name="Position">Origin of the frame in the world, metres.</param>
/// <param name="Axes">Orientation of the frame.</param>
public readonly record struct Pose(Vector3D Position, Axes Axes)
{
    /// <summary>A point of this frame, in the world.</summary>
    public Vector3D ToWorld(Vector3D local) => Position + Axes.ToWorld(local);

    /// <summary>A point of the world, in this frame.</summary>
    public Vector3D ToLocal(Vector3D world) => Axes.ToLocal(world - Position);

    /// <summary>A pose given in this frame, in the world: a camera mounted on a car, say.</summary>
    public Pose Compose(Pose local) =>
        new(
            ToWorld(local.Position),
            Axes.FromVectors(Axes.ToWorld(local.Axes.Right), Axes.ToWorld(local.Axes.Forward), Axes.ToWorld(local.Axes.Up)));
}
