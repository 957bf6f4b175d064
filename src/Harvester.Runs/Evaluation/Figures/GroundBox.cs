using Harvester.Geometry;

namespace Harvester.Runs.Evaluation.Figures;

/// <summary>A body seen from above: a rectangle on the ground with a range of heights.</summary>
/// <param name="Centre">Centre, world x and y, metres.</param>
/// <param name="Forward">Unit vector along its length.</param>
/// <param name="HalfLength">Half of the length, metres.</param>
/// <param name="HalfWidth">Half of the width, metres.</param>
/// <param name="Bottom">Height of its lowest point, metres.</param>
/// <param name="Top">Height of its highest point, metres.</param>
public readonly record struct GroundBox(Vector2D Centre, Vector2D Forward, double HalfLength, double HalfWidth, double Bottom, double Top)
{
    /// <summary>The box of a model's extents at a pose, ignoring the small tilt on slopes.</summary>
    public static GroundBox Of(Pose pose, Vector3D min, Vector3D max)
    {
        Vector3D centre = pose.ToWorld((min + max) * 0.5);
        Vector3D forward = pose.Axes.Forward;
        double length = Math.Sqrt((forward.X * forward.X) + (forward.Y * forward.Y));
        double halfHeight = (max.Z - min.Z) / 2;
        return new GroundBox(
            new Vector2D(centre.X, centre.Y),
            new Vector2D(forward.X / length, forward.Y / length),
            (max.Y - min.Y) / 2,
            (max.X - min.X) / 2,
            centre.Z - halfHeight,
            centre.Z + halfHeight
        );
    }

    /// <summary>Whether two bodies overlap: no line along a side of either separates them.</summary>
    public bool Overlaps(GroundBox other) =>
        Bottom < other.Top
        && other.Bottom < Top
        && !IsParted(other, Forward)
        && !IsParted(other, Left(Forward))
        && !IsParted(other, other.Forward)
        && !IsParted(other, Left(other.Forward));

    private bool IsParted(GroundBox other, Vector2D axis) => Math.Abs((other.Centre - Centre).Dot(axis)) > Reach(axis) + other.Reach(axis);

    private double Reach(Vector2D axis) => (Math.Abs(Forward.Dot(axis)) * HalfLength) + (Math.Abs(Forward.Cross(axis)) * HalfWidth);

    private static Vector2D Left(Vector2D vector) => new(-vector.Y, vector.X);
}
