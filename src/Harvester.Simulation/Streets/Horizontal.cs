using Harvester.Geometry;

namespace Harvester.Simulation.Streets;

/// <summary>Directions on the ground, independent of slope.</summary>
internal static class Horizontal
{
    public static readonly Vector3D Up = new(0, 0, 1);

    /// <summary>The horizontal unit vector to the right of a direction that is not vertical.</summary>
    public static Vector3D RightOf(Vector3D forward)
    {
        double length = Math.Sqrt((forward.X * forward.X) + (forward.Y * forward.Y));
        return new Vector3D(forward.Y / length, -forward.X / length, 0);
    }

    public static double Distance(Vector3D a, Vector3D b) => Math.Sqrt(SquaredDistance(a, b));

    public static double SquaredDistance(Vector3D a, Vector3D b)
    {
        double dx = a.X - b.X;
        double dy = a.Y - b.Y;
        return (dx * dx) + (dy * dy);
    }

    /// <summary>Angle of the turn from one direction to another, radians, positive to the left.</summary>
    public static double Turn(Vector3D from, Vector3D to) =>
        Math.Atan2((from.X * to.Y) - (from.Y * to.X), (from.X * to.X) + (from.Y * to.Y));

    /// <summary>The orientation of an object on a slope that does not lean to a side.</summary>
    public static Axes AxesAlong(Vector3D unitForward)
    {
        Vector3D right = RightOf(unitForward);
        return Axes.FromVectors(right, unitForward, right.Cross(unitForward));
    }
}
