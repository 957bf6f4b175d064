namespace Harvester.Geometry.Visibility;

/// <summary>A point on a surface that a ray hit.</summary>
/// <param name="Entity">Handle of the entity that was hit; <see cref="RayHit.World"/> for the world.</param>
/// <param name="Place">The point, metres, world.</param>
internal readonly record struct SurfacePoint(int Entity, Vector3D Place)
{
    /// <summary>
    /// Maximum distance of a point from the plane of the others, metres: walls have reliefs. With 0.1, a frame of a quiet street
    /// takes 2 % more rays.
    /// </summary>
    private const double MaxRelief = 0.2;

    /// <summary>The point at which a ray hit something.</summary>
    public static SurfacePoint Of(Ray ray, RayHit hit) => new(hit.Entity, ray.At(hit.Distance));

    /// <summary>
    /// Whether points are on one thing without gaps between them: one entity, or a plane of the world. Four points or more show a plane;
    /// those on the crown of a tree, or on houses on both sides of a gap through which one sees far, are on none.
    /// </summary>
    public static bool AreOnOneThing(IReadOnlyList<SurfacePoint> points)
    {
        foreach (SurfacePoint point in points)
        {
            if (point.Entity != points[0].Entity)
            {
                return false;
            }
        }

        return points[0].Entity != RayHit.World || AreOnPlane(points);
    }

    /// <summary>
    /// The plane goes through the first point a, the one b that is farthest from it, and the one c that is farthest from the line ab. The
    /// normal is (b - a) × (c - a); all points on one line are on a plane as well.
    /// </summary>
    private static bool AreOnPlane(IReadOnlyList<SurfacePoint> points)
    {
        Vector3D first = points[0].Place;
        Vector3D along = Longest(points, point => point - first);
        Vector3D normal = Longest(points, point => along.Cross(point - first));
        foreach (SurfacePoint point in points)
        {
            if (Math.Abs(normal.Dot(point.Place - first)) > MaxRelief * normal.Length)
            {
                return false;
            }
        }

        return true;
    }

    private static Vector3D Longest(IReadOnlyList<SurfacePoint> points, Func<Vector3D, Vector3D> vectorOf)
    {
        Vector3D longest = Vector3D.Zero;
        foreach (SurfacePoint point in points)
        {
            Vector3D vector = vectorOf(point.Place);
            longest = vector.Length > longest.Length ? vector : longest;
        }

        return longest;
    }
}
