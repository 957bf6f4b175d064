using Harvester.Geometry;

namespace Harvester.Simulation.Rendering;

/// <summary>A 4x4 matrix of doubles by rows, for column vectors: the transform of p is M · p, and A · B applies B first.</summary>
internal readonly record struct Matrix4(Vector4 Row0, Vector4 Row1, Vector4 Row2, Vector4 Row3)
{
    public static Matrix4 operator *(Matrix4 a, Matrix4 b) =>
        new(Combine(a.Row0, b), Combine(a.Row1, b), Combine(a.Row2, b), Combine(a.Row3, b));

    /// <summary>Transforms a frame's own coordinates to world coordinates.</summary>
    public static Matrix4 ToWorld(Pose pose) =>
        new(
            new(pose.Axes.Right.X, pose.Axes.Forward.X, pose.Axes.Up.X, pose.Position.X),
            new(pose.Axes.Right.Y, pose.Axes.Forward.Y, pose.Axes.Up.Y, pose.Position.Y),
            new(pose.Axes.Right.Z, pose.Axes.Forward.Z, pose.Axes.Up.Z, pose.Position.Z),
            new(0, 0, 0, 1)
        );

    /// <summary>Transforms world coordinates to a frame's own: the transposed rotation after the opposite translation.</summary>
    public static Matrix4 FromWorld(Pose pose) =>
        new(
            InverseRow(pose.Axes.Right, pose.Position),
            InverseRow(pose.Axes.Forward, pose.Position),
            InverseRow(pose.Axes.Up, pose.Position),
            new(0, 0, 0, 1)
        );

    /// <summary>Transforms a point to homogeneous coordinates.</summary>
    public Vector4 Transform(Vector3D point) => new(Dot(Row0, point), Dot(Row1, point), Dot(Row2, point), Dot(Row3, point));

    private static Vector4 InverseRow(Vector3D axis, Vector3D position) =>
        new(axis.X, axis.Y, axis.Z, -((axis.X * position.X) + (axis.Y * position.Y) + (axis.Z * position.Z)));

    private static Vector4 Combine(Vector4 row, Matrix4 b) => (b.Row0 * row.X) + (b.Row1 * row.Y) + (b.Row2 * row.Z) + (b.Row3 * row.W);

    private static double Dot(in Vector4 row, Vector3D point) => (row.X * point.X) + (row.Y * point.Y) + (row.Z * point.Z) + row.W;
}
