using Harvester.Geometry;

namespace Harvester.Exports;

/// <summary>A rotation to the world as a unit quaternion, with w not negative.</summary>
internal readonly record struct Rotation(double X, double Y, double Z, double W)
{
    public static Rotation None { get; } = new(0, 0, 0, 1);

    /// <summary>From a frame with x forward, y left and z up.</summary>
    public static Rotation OfBody(Axes axes) => OfColumns(axes.Forward, -axes.Right, axes.Up);

    /// <summary>From a frame with x right, y forward and z up.</summary>
    public static Rotation OfSensor(Axes axes) => OfColumns(axes.Right, axes.Forward, axes.Up);

    /// <summary>From a frame with x right, y down and z forward.</summary>
    public static Rotation OfCamera(Axes axes) => OfColumns(axes.Right, -axes.Up, axes.Forward);

    /// <summary>
    /// The quaternion of the matrix with these columns, from the largest of its four squared parts, which 1 plus or minus the diagonal
    /// elements gives (Shepperd, "Quaternion from rotation matrix", 1978).
    /// </summary>
    private static Rotation OfColumns(Vector3D x, Vector3D y, Vector3D z)
    {
        double trace = x.X + y.Y + z.Z;
        (double X, double Y, double Z, double W) q;
        if (trace > x.X && trace > y.Y && trace > z.Z)
        {
            q = (y.Z - z.Y, z.X - x.Z, x.Y - y.X, 1 + trace);
        }
        else if (x.X >= y.Y && x.X >= z.Z)
        {
            q = (1 + x.X - y.Y - z.Z, x.Y + y.X, z.X + x.Z, y.Z - z.Y);
        }
        else if (y.Y >= z.Z)
        {
            q = (x.Y + y.X, 1 - x.X + y.Y - z.Z, y.Z + z.Y, z.X - x.Z);
        }
        else
        {
            q = (z.X + x.Z, y.Z + z.Y, 1 - x.X - y.Y + z.Z, x.Y - y.X);
        }

        double length = Math.Sqrt((q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W)) * (q.W < 0 ? -1 : 1);
        return new Rotation(q.X / length, q.Y / length, q.Z / length, q.W / length);
    }
}
