using Harvester.Geometry;

namespace Harvester.Play.Features;

/// <summary>A path along which the game's tasks lead an actor, from point to point ahead of it.</summary>
/// <param name="points">At least two points, metres, world.</param>
internal sealed class ActorPath(IReadOnlyList<Vector3D> points)
{
    /// <summary>The actor is at the end of its path within this distance, metres.</summary>
    private const double AtEnd = 3;

    private int _segment;

    /// <summary>Whether a place is at the end of the path.</summary>
    public bool IsEnd(Vector3D place) => _segment == points.Count - 2 && Flat(points[points.Count - 1] - place).Length < AtEnd;

    /// <summary>The point of the path a distance ahead of a place; its end if that is nearer. The place moves forward only.</summary>
    /// <param name="place">Where the actor is.</param>
    /// <param name="metres">The distance along the path.</param>
    public Vector3D Ahead(Vector3D place, double metres)
    {
        double along = Along(_segment, place);
        while (along >= LengthOf(_segment) && _segment < points.Count - 2)
        {
            _segment++;
            along = Along(_segment, place);
        }

        double left = Math.Max(0, along) + metres;
        int segment = _segment;
        while (left > LengthOf(segment) && segment < points.Count - 2)
        {
            left -= LengthOf(segment++);
        }

        double length = LengthOf(segment);
        Vector3D from = points[segment];
        return from + ((points[segment + 1] - from) * (length > 0 ? Math.Min(1, left / length) : 1));
    }

    private double LengthOf(int segment) => Flat(points[segment + 1] - points[segment]).Length;

    /// <summary>Metres along a segment to the point nearest to a place, beyond its ends too.</summary>
    private double Along(int segment, Vector3D place)
    {
        Vector3D side = Flat(points[segment + 1] - points[segment]);
        double length = side.Length;
        return length > 0 ? Flat(place - points[segment]).Dot(side) / length : 0;
    }

    private static Vector3D Flat(Vector3D vector) => vector with { Z = 0 };
}
