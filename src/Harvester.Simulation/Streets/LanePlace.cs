using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>The position of a point along and beside a path.</summary>
/// <param name="Path">The path.</param>
/// <param name="Distance">Metres from its start to the closest point on it; an end if the point lies beyond it.</param>
/// <param name="RightOffset">Metres to the right of its line.</param>
/// <param name="Height">Metres above it.</param>
/// <param name="Beyond">Metres that the point lies beyond its end, negative before its start; 0 beside it.</param>
internal readonly record struct LanePlace(LanePath Path, double Distance, double RightOffset, double Height, double Beyond)
{
    private const int ProjectionSteps = 6;

    /// <summary>The position of a point on a path, searched from a distance near it.</summary>
    public static LanePlace Of(LanePath path, Vector3D point, double near)
    {
        double distance = Math.Clamp(near, 0, path.Length);
        for (int i = 0; i < ProjectionSteps; i++)
        {
            distance = Math.Clamp(distance + Along(path, distance, point), 0, path.Length);
        }

        Vector3D offset = point - path.Line.PositionAt(distance);
        double left = Along(path, distance, point);
        double beyond =
            distance == path.Length ? Math.Max(0, left)
            : distance == 0 ? Math.Min(0, left)
            : 0;
        return new LanePlace(path, distance, offset.Dot(Horizontal.RightOf(path.Line.TangentAt(distance))), offset.Z, beyond);
    }

    private static double Along(LanePath path, double distance, Vector3D point)
    {
        Vector3D offset = point - path.Line.PositionAt(distance);
        Vector3D tangent = path.Line.TangentAt(distance);
        return (offset.X * tangent.X) + (offset.Y * tangent.Y);
    }
}
