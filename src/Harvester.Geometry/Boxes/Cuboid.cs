namespace Harvester.Geometry.Boxes;

/// <summary>An oriented box in the world: the 3D bounding box of an entity.</summary>
public sealed record Cuboid
{
    private static readonly int[] EdgeStarts = [0, 0, 0, 1, 1, 2, 2, 3, 4, 4, 5, 6];
    private static readonly int[] EdgeEnds = [1, 2, 4, 3, 5, 3, 6, 7, 5, 6, 7, 7];

    /// <summary>Number of corners of a cuboid.</summary>
    public const int CornerCount = 8;

    /// <summary>Number of edges of a cuboid.</summary>
    internal const int EdgeCount = 12;

    /// <summary>Creates a cuboid from its centre, half extents and axes.</summary>
    /// <param name="centre">Its centre in the world, metres.</param>
    /// <param name="halfExtents">Half of its size along right, forward and up, metres; each 0 or more (a plate has one 0).</param>
    /// <param name="axes">Its orientation.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite, or an extent is negative.</exception>
    /// <exception cref="ArgumentException">The axes are the default value, which is not an orientation.</exception>
    public Cuboid(Vector3D centre, Vector3D halfExtents, Axes axes)
    {
        Centre = Guard.Finite(centre, nameof(centre));
        HalfExtents = Guard.Finite(halfExtents, nameof(halfExtents));
        if (halfExtents.X < 0 || halfExtents.Y < 0 || halfExtents.Z < 0)
        {
            throw new ArgumentOutOfRangeException(nameof(halfExtents), halfExtents, "A cuboid's half extents are 0 or more.");
        }

        Axes = Guard.Orientation(axes, nameof(axes));
    }

    /// <summary>The twelve edges as pairs of corner numbers (see <see cref="Corner"/>).</summary>
    public static IEnumerable<(int Start, int End)> Edges
    {
        get
        {
            for (int i = 0; i < EdgeStarts.Length; i++)
            {
                yield return (EdgeStarts[i], EdgeEnds[i]);
            }
        }
    }

    /// <summary>The twelve edges as end points in the world, metres.</summary>
    public IEnumerable<(Vector3D Start, Vector3D End)> EdgesInWorld
    {
        get
        {
            for (int i = 0; i < EdgeStarts.Length; i++)
            {
                yield return (Corner(EdgeStarts[i]), Corner(EdgeEnds[i]));
            }
        }
    }

    /// <summary>Centre in the world, metres.</summary>
    public Vector3D Centre { get; }

    /// <summary>Half of the size along right, forward and up, metres.</summary>
    public Vector3D HalfExtents { get; }

    /// <summary>Orientation: the directions of right, forward and up in the world.</summary>
    public Axes Axes { get; }

    /// <summary>
    /// The cuboid of an entity from its model's dimensions. These are a minimum and a maximum about the model's origin and not symmetric,
    /// so the centre differs from the entity's position.
    /// </summary>
    /// <param name="min">Rear, left, lower corner in the model's frame, metres.</param>
    /// <param name="max">Front, right, upper corner in the model's frame, metres; no component less than <paramref name="min"/>'s.</param>
    /// <param name="entity">The entity's pose in the world.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is not finite, or a minimum is greater than its maximum.</exception>
    public static Cuboid FromModel(Vector3D min, Vector3D max, Pose entity)
    {
        Guard.Finite(min, nameof(min));
        Guard.Finite(max, nameof(max));
        return new Cuboid(entity.ToWorld((min + max) * 0.5), (max - min) * 0.5, entity.Axes);
    }

    /// <summary>
    /// A corner in the world, metres. Bit 0 of the number is right, bit 1 forward, bit 2 up; a cleared bit is the opposite side.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The number is not from 0 to 7.</exception>
    public Vector3D Corner(int number)
    {
        if (number is < 0 or > 7)
        {
            throw new ArgumentOutOfRangeException(nameof(number), number, "A cuboid has the corners 0 to 7.");
        }

        return Centre
            + Axes.ToWorld(
                new Vector3D(
                    (number & 1) != 0 ? HalfExtents.X : -HalfExtents.X,
                    (number & 2) != 0 ? HalfExtents.Y : -HalfExtents.Y,
                    (number & 4) != 0 ? HalfExtents.Z : -HalfExtents.Z
                )
            );
    }

    /// <summary>An edge as the numbers of its corners.</summary>
    internal static (int Start, int End) Edge(int number) => (EdgeStarts[number], EdgeEnds[number]);

    /// <summary>Whether a point of the world lies in the cuboid, faces included.</summary>
    public bool Contains(Vector3D world)
    {
        Vector3D local = Axes.ToLocal(world - Centre);
        return Math.Abs(local.X) <= HalfExtents.X && Math.Abs(local.Y) <= HalfExtents.Y && Math.Abs(local.Z) <= HalfExtents.Z;
    }

    /// <summary>
    /// Intersects a ray with the cuboid: the distances of entry and exit, metres. Entry is 0 if the ray starts inside. Slab test: the ray
    /// is inside while it is between all three pairs of faces, so the last entry must come before the first exit.
    /// </summary>
    /// <returns>Null if the ray misses the cuboid or starts beyond it.</returns>
    public RaySpan? Intersect(Ray ray)
    {
        Vector3D origin = Axes.ToLocal(ray.Origin - Centre);
        Vector3D direction = Axes.ToLocal(ray.Direction);
        double entry = 0;
        double exit = double.PositiveInfinity;
        bool hit =
            Slab(origin.X, direction.X, HalfExtents.X, ref entry, ref exit)
            && Slab(origin.Y, direction.Y, HalfExtents.Y, ref entry, ref exit)
            && Slab(origin.Z, direction.Z, HalfExtents.Z, ref entry, ref exit);
        return hit ? new RaySpan(entry, exit) : null;
    }

    private static bool Slab(double origin, double direction, double half, ref double entry, ref double exit)
    {
        // A ray parallel to a pair of faces never crosses them: it is between them throughout, or it misses.
        if (direction == 0)
        {
            return Math.Abs(origin) <= half;
        }

        double a = (-half - origin) / direction;
        double b = (half - origin) / direction;
        entry = Math.Max(entry, Math.Min(a, b));
        exit = Math.Min(exit, Math.Max(a, b));
        return entry <= exit;
    }
}
