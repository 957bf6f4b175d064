using Harvester.Geometry;

namespace Harvester.Simulation.Traffic;

/// <summary>The rectangle that a body covers on the ground.</summary>
/// <param name="Centre">Middle, metres, world.</param>
/// <param name="Forward">Horizontal unit direction of its length.</param>
/// <param name="HalfLength">Metres.</param>
/// <param name="HalfWidth">Metres.</param>
internal readonly record struct Footprint(Vector3D Centre, Vector3D Forward, double HalfLength, double HalfWidth)
{
    /// <summary>Maximum height difference of bodies on one level of a bridge, metres.</summary>
    private const double SameLevel = 3.5;

    public static Footprint Of(Pose pose, Vector3D min, Vector3D max)
    {
        Vector3D forward = pose.Axes.Forward;
        Vector3D level = new Vector3D(forward.X, forward.Y, 0).Normalized();
        return new Footprint(pose.ToWorld((min + max) * 0.5), level, (max.Y - min.Y) / 2, (max.X - min.X) / 2);
    }

    public Footprint Grown(double margin) => this with { HalfLength = HalfLength + margin, HalfWidth = HalfWidth + margin };

    /// <summary>Whether two rectangles overlap: no side of either separates them.</summary>
    public bool Overlaps(Footprint other)
    {
        Vector3D offset = other.Centre - Centre;
        return Math.Abs(offset.Z) < SameLevel
            && !IsParted(this, other, offset, Forward)
            && !IsParted(this, other, offset, Streets.Horizontal.RightOf(Forward))
            && !IsParted(this, other, offset, other.Forward)
            && !IsParted(this, other, offset, Streets.Horizontal.RightOf(other.Forward));
    }

    private static bool IsParted(Footprint a, Footprint b, Vector3D offset, Vector3D axis) =>
        Math.Abs((offset.X * axis.X) + (offset.Y * axis.Y)) > a.Reach(axis) + b.Reach(axis);

    private double Reach(Vector3D axis)
    {
        // Half the length of the rectangle's shadow on the axis; two rectangles are apart if their shadows on the direction of a side are.
        double along = Math.Abs((Forward.X * axis.X) + (Forward.Y * axis.Y));
        double across = Math.Abs((Forward.Y * axis.X) - (Forward.X * axis.Y));
        return (along * HalfLength) + (across * HalfWidth);
    }
}
