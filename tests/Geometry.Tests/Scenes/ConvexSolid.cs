using Harvester.Geometry.Boxes;

namespace Harvester.Geometry.Tests.Scenes;

/// <summary>A convex solid as the half spaces that it lies in, each given by an outward normal and a point of its plane.</summary>
internal sealed class ConvexSolid
{
    private readonly (Vector3D Normal, double Offset)[] _planes;

    private ConvexSolid(IEnumerable<(Vector3D Normal, Vector3D Point)> planes)
    {
        _planes = [.. planes.Select(plane => (plane.Normal, plane.Normal.Dot(plane.Point)))];
    }

    public static ConvexSolid Of(Cuboid cuboid) => Frustum(cuboid, 1, 1);

    /// <summary>
    /// A cuboid whose top is drawn in towards its middle to shares of its width and length: the cabin of a car, a tapered post.
    /// </summary>
    public static ConvexSolid Frustum(Cuboid cuboid, double topWidth, double topLength)
    {
        (double x, double y, double z) = cuboid.HalfExtents;
        double leanX = x * (1 - topWidth) / (2 * z);
        double leanY = y * (1 - topLength) / (2 * z);
        Vector3D bottom = new(0, 0, -z);
        (Vector3D Normal, Vector3D Point)[] local =
        [
            (new(1, 0, leanX), bottom + new Vector3D(x, 0, 0)),
            (new(-1, 0, leanX), bottom + new Vector3D(-x, 0, 0)),
            (new(0, 1, leanY), bottom + new Vector3D(0, y, 0)),
            (new(0, -1, leanY), bottom + new Vector3D(0, -y, 0)),
            (new(0, 0, 1), new(0, 0, z)),
            (new(0, 0, -1), bottom),
        ];
        return new ConvexSolid(local.Select(p => (cuboid.Axes.ToWorld(p.Normal), cuboid.Centre + cuboid.Axes.ToWorld(p.Point))));
    }

    /// <summary>The distance at which a ray enters, or null when it misses or starts inside, as in the game.</summary>
    public double? Enter(Ray ray)
    {
        double entry = 0;
        double exit = double.PositiveInfinity;
        foreach ((Vector3D normal, double offset) in _planes)
        {
            double towards = normal.Dot(ray.Direction);
            double outside = normal.Dot(ray.Origin) - offset;
            if (towards < 0)
            {
                entry = Math.Max(entry, outside / -towards);
            }
            else if (towards > 0)
            {
                exit = Math.Min(exit, -outside / towards);
            }
            else if (outside > 0)
            {
                return null;
            }

            if (entry > exit)
            {
                return null;
            }
        }

        return entry > 0 ? entry : null;
    }
}
