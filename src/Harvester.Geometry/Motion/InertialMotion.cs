namespace Harvester.Geometry.Motion;

/// <summary>
/// What an ideal inertial unit measures over an interval, from the states at its ends: mean angular rate and mean specific force. Both
/// are in the axes of the body: right, forward, up.
/// </summary>
public static class InertialMotion
{
    /// <summary>Standard gravity, m/s² (3rd General Conference on Weights and Measures, 1901), downwards in the world.</summary>
    public const double Gravity = 9.80665;

    /// <summary>Below this length, the sine of an angle is the angle, to the precision of a double.</summary>
    private const double SmallSine = 1e-9;

    /// <summary>
    /// The rotation vector from one orientation to another: the axis, in the axes of either, times the angle, radians, right-handed, less
    /// than π. Divided by the time it is the constant angular rate that leads from the one to the other.
    /// </summary>
    /// <param name="from">The orientation before.</param>
    /// <param name="to">The orientation after.</param>
    public static Vector3D Rotation(Axes from, Axes to)
    {
        // The matrix from the body after to the body before has the elements M_ij = from_i · to_j.
        Vector3D right = from.ToLocal(to.Right);
        Vector3D forward = from.ToLocal(to.Forward);
        Vector3D up = from.ToLocal(to.Up);

        // Its antisymmetric part is the axis times the sine of the angle, and its trace is 1 + 2 cos.
        Vector3D sine = new Vector3D(forward.Z - up.Y, up.X - right.Z, right.Y - forward.X) * 0.5;
        double cosine = (right.X + forward.Y + up.Z - 1) / 2;
        double length = sine.Length;
        return length < SmallSine ? sine : sine * (Math.Atan2(length, cosine) / length);
    }

    /// <summary>
    /// The mean specific force over an interval, m/s²: the acceleration without gravity, in the axes that the body has in the middle of
    /// it. At rest it is <see cref="Gravity"/> upwards.
    /// </summary>
    /// <param name="from">The orientation at the beginning.</param>
    /// <param name="rotation">The rotation during the interval, as <see cref="Rotation"/> gives it.</param>
    /// <param name="velocityChange">Change of the velocity in the world, m/s.</param>
    /// <param name="seconds">Length of the interval, seconds; greater than 0.</param>
    public static Vector3D SpecificForce(Axes from, Vector3D rotation, Vector3D velocityChange, double seconds)
    {
        Vector3D force = from.ToLocal((velocityChange / seconds) + new Vector3D(0, 0, Gravity));

        // Turned back by half the rotation, from the axes at the beginning to those in the middle.
        return Turned(force, rotation * -0.5);
    }

    /// <summary>A vector turned by a rotation vector: Rodrigues' formula.</summary>
    private static Vector3D Turned(Vector3D vector, Vector3D rotation)
    {
        double angle = rotation.Length;
        if (angle < SmallSine)
        {
            return vector + rotation.Cross(vector);
        }

        Vector3D axis = rotation / angle;
        double cosine = Math.Cos(angle);
        return (vector * cosine) + (axis.Cross(vector) * Math.Sin(angle)) + (axis * (axis.Dot(vector) * (1 - cosine)));
    }
}
