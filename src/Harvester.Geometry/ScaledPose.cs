namespace Harvester.Geometry;

/// <summary>
/// A pose with a scale along each axis of its own frame: what a game's matrix holds that makes its model larger or smaller.
/// </summary>
/// <param name="Pose">The rigid part.</param>
/// <param name="Scale">Factors along right, forward and up; 1 leaves a length as it is.</param>
public readonly record struct ScaledPose(Pose Pose, Vector3D Scale)
{
    /// <summary>How far a length may be off 1 and still be 1: the single precision of games, with room.</summary>
    private const double UnitTolerance = 1e-3;

    /// <summary>Below this factor a thing is no larger than a grain: it is hidden, not scaled.</summary>
    private const double MinScale = 1e-3;

    /// <summary>
    /// Splits a matrix into a rotation and a scale along the axes of its own frame. Lengths within 0.001 of 1 are taken for 1, so that a
    /// rigid matrix gives the pose that it always gave.
    /// </summary>
    /// <param name="right">The matrix' vector for x, in the world.</param>
    /// <param name="forward">The matrix' vector for y, in the world.</param>
    /// <param name="up">The matrix' vector for z, in the world.</param>
    /// <param name="position">Origin of the frame in the world, metres.</param>
    /// <returns>Null for a matrix that is not finite, vanishes, is sheared or mirrors: no rotation and scale make it.</returns>
    public static ScaledPose? FromMatrix(Vector3D right, Vector3D forward, Vector3D up, Vector3D position)
    {
        var scale = new Vector3D(ScaleOf(right), ScaleOf(forward), ScaleOf(up));
        return position.IsFinite && IsUsable(scale.X) && IsUsable(scale.Y) && IsUsable(scale.Z)
            && Axes.TryFromVectors(right / scale.X, forward / scale.Y, up / scale.Z) is { } axes
            ? new ScaledPose(new Pose(position, axes), scale)
            : null;
    }

    /// <summary>A point of the model, such as a corner of its extents, where the scale puts it in the pose's frame.</summary>
    public Vector3D Stretch(Vector3D point) => new(point.X * Scale.X, point.Y * Scale.Y, point.Z * Scale.Z);

    private static double ScaleOf(Vector3D vector)
    {
        double length = vector.Length;
        return System.Math.Abs(length - 1) <= UnitTolerance ? 1 : length;
    }

    private static bool IsUsable(double scale) => scale >= MinScale && !double.IsInfinity(scale);
}
