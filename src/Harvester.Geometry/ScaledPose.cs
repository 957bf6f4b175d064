namespace Harvester.Geometry;

/// <summary>A pose with a scale along each axis of its own frame, as in a game's matrix that makes its model larger or smaller.</summary>
/// <param name="Pose">The rigid part.</param>
/// <param name="Scale">Factors along right, forward and up; 1 leaves a length unchanged.</param>
public readonly record struct ScaledPose(Pose Pose, Vector3D Scale)
{
    /// <summary>Maximum deviation of a length from 1 that still counts as 1: the single precision of games, with room.</summary>
    private const double UnitTolerance = 1e-3;

    /// <summary>An object scaled by less than this factor is hidden, not small.</summary>
    private const double MinScale = 1e-3;

    /// <summary>
    /// Splits a matrix into a rotation and a scale along the axes of its own frame. Lengths within 0.001 of 1 count as 1, so that a rigid
    /// matrix gives an unscaled pose.
    /// </summary>
    /// <param name="right">The matrix's vector for x, in the world.</param>
    /// <param name="forward">The matrix's vector for y, in the world.</param>
    /// <param name="up">The matrix's vector for z, in the world.</param>
    /// <param name="position">Origin of the frame in the world, metres.</param>
    /// <returns>Null for a matrix that is not finite, vanishes, is sheared or mirrors: no rotation and scale give it.</returns>
    public static ScaledPose? FromMatrix(Vector3D right, Vector3D forward, Vector3D up, Vector3D position)
    {
        var scale = new Vector3D(ScaleOf(right), ScaleOf(forward), ScaleOf(up));
        return
            position.IsFinite
            && IsUsable(scale.X)
            && IsUsable(scale.Y)
            && IsUsable(scale.Z)
            && Axes.TryFromVectors(right / scale.X, forward / scale.Y, up / scale.Z) is { } axes
            ? new ScaledPose(new Pose(position, axes), scale)
            : null;
    }

    /// <summary>Scales a point of the model, such as a corner of its extents, to the pose's frame.</summary>
    public Vector3D Stretch(Vector3D point) => new(point.X * Scale.X, point.Y * Scale.Y, point.Z * Scale.Z);

    private static double ScaleOf(Vector3D vector)
    {
        double length = vector.Length;
        return System.Math.Abs(length - 1) <= UnitTolerance ? 1 : length;
    }

    private static bool IsUsable(double scale) => scale >= MinScale && !double.IsInfinity(scale);
}
