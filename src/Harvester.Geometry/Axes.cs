namespace Harvester.Geometry;

/// <summary>
/// The orientation of a camera or an entity: its right, forward and up directions as orthonormal vectors of the world,
/// right-handed (right × forward = up). The default value is not an orientation; start from <see cref="Identity"/>.
/// </summary>
public readonly record struct Axes
{
    /// <summary>
    /// Maximum deviation of a given vector's length from 1, or of the cosine between two from 0: the single precision of the game, with
    /// room.
    /// </summary>
    private const double OrthonormalTolerance = 1e-3;

    /// <summary>Deviation from orthonormality that the rounding of doubles may cause.</summary>
    private const double RoundingTolerance = 1e-14;

    private Axes(Vector3D right, Vector3D forward, Vector3D up)
    {
        Right = right;
        Forward = forward;
        Up = up;
    }

    /// <summary>Right is east, forward is north, up is up: the world's own axes.</summary>
    public static Axes Identity { get; } = new(new(1, 0, 0), new(0, 1, 0), new(0, 0, 1));

    /// <summary>Whether this is an orientation; false for the default value.</summary>
    internal bool IsOrientation => Forward != Vector3D.Zero;

    /// <summary>Unit vector to the right, in the world.</summary>
    public Vector3D Right { get; }

    /// <summary>Unit vector forward, in the world.</summary>
    public Vector3D Forward { get; }

    /// <summary>Unit vector upward, in the world.</summary>
    public Vector3D Up { get; }

    /// <summary>
    /// Makes an orientation from three nearly orthonormal vectors, as single-precision sources give them: forward keeps its direction,
    /// right is made perpendicular to it, up follows. Vectors that are orthonormal up to the rounding of doubles are kept unchanged, so
    /// that an orientation written in full is read back exactly.
    /// </summary>
    /// <exception cref="ArgumentException">The vectors deviate from unit length or from right angles by more than 0.001, or are
    /// left-handed.</exception>
    public static Axes FromVectors(Vector3D right, Vector3D forward, Vector3D up)
    {
        Guard.Finite(right, nameof(right));
        Guard.Finite(forward, nameof(forward));
        Guard.Finite(up, nameof(up));
        return TryFromVectors(right, forward, up)
            ?? throw new ArgumentException("The axes must be unit vectors, square to each other and right-handed (right × forward = up).");
    }

    /// <summary>As <see cref="FromVectors"/>; null for vectors that it rejects.</summary>
    internal static Axes? TryFromVectors(Vector3D right, Vector3D forward, Vector3D up)
    {
        if (
            !IsUnit(right)
            || !IsUnit(forward)
            || !IsUnit(up)
            || Math.Abs(right.Dot(forward)) > OrthonormalTolerance
            || (right.Cross(forward) - up).Length > 3 * OrthonormalTolerance
        )
        {
            return null;
        }

        if (
            Math.Abs(forward.Length - 1) <= RoundingTolerance
            && Math.Abs(right.Length - 1) <= RoundingTolerance
            && Math.Abs(right.Dot(forward)) <= RoundingTolerance
            && (right.Cross(forward) - up).Length <= RoundingTolerance
        )
        {
            return new Axes(right, forward, up);
        }

        // Gram-Schmidt: forward is kept, right is made square to it, up follows from both.
        Vector3D unitForward = forward.Normalized();
        Vector3D unitRight = (right - (unitForward * right.Dot(unitForward))).Normalized();
        return new Axes(unitRight, unitForward, unitRight.Cross(unitForward));
    }

    /// <summary>The orientation of the game's Euler angles: the columns of Rz(yaw) · Rx(pitch) · Ry(roll).</summary>
    /// <exception cref="ArgumentOutOfRangeException">An angle is not finite.</exception>
    public static Axes FromEuler(EulerAngles angles)
    {
        double pitch = Angles.ToRadians(Guard.Finite(angles.PitchDegrees, nameof(angles)));
        double roll = Angles.ToRadians(Guard.Finite(angles.RollDegrees, nameof(angles)));
        double yaw = Angles.ToRadians(Guard.Finite(angles.YawDegrees, nameof(angles)));
        double sp = Math.Sin(pitch),
            cp = Math.Cos(pitch);
        double sr = Math.Sin(roll),
            cr = Math.Cos(roll);
        double sy = Math.Sin(yaw),
            cy = Math.Cos(yaw);
        return new Axes(
            new((cy * cr) - (sy * sp * sr), (sy * cr) + (cy * sp * sr), -cp * sr),
            new(-sy * cp, cy * cp, sp),
            new((cy * sr) + (sy * sp * cr), (sy * sr) - (cy * sp * cr), cp * cr)
        );
    }

    /// <summary>A level orientation with the game's heading: degrees counter-clockwise from north.</summary>
    public static Axes FromHeading(double headingDegrees) => FromEuler(new EulerAngles(0, 0, headingDegrees));

    /// <summary>
    /// The game's Euler angles of this orientation: pitch in [-90, 90], roll and yaw in (-180, 180] degrees. Looking straight up or down,
    /// roll and yaw turn about the same axis; roll is then 0.
    /// </summary>
    public EulerAngles ToEuler()
    {
        // Forward is (-sin yaw cos pitch, cos yaw cos pitch, sin pitch); right.z and up.z are -cos pitch sin roll and cos pitch cos roll.
        double cosPitch = Math.Sqrt((Right.Z * Right.Z) + (Up.Z * Up.Z));
        double pitch = Math.Atan2(Forward.Z, cosPitch);
        const double gimbalLockCosine = 1e-9;
        if (cosPitch < gimbalLockCosine)
        {
            return new EulerAngles(Angles.ToDegrees(pitch), 0, Angles.ToDegrees(Math.Atan2(Right.Y, Right.X)));
        }

        // 0 - x instead of -x: the arctangent of a negative zero would give -180, which is outside the range.
        double roll = Math.Atan2(0 - Right.Z, Up.Z);
        double yaw = Math.Atan2(0 - Forward.X, Forward.Y);
        return new EulerAngles(Angles.ToDegrees(pitch), Angles.ToDegrees(roll), Angles.ToDegrees(yaw));
    }

    /// <summary>Transforms a direction of this frame (x right, y forward, z up) to the world.</summary>
    public Vector3D ToWorld(Vector3D local) => (Right * local.X) + (Forward * local.Y) + (Up * local.Z);

    /// <summary>Transforms a direction of the world to this frame (x right, y forward, z up).</summary>
    public Vector3D ToLocal(Vector3D world) => new(Right.Dot(world), Forward.Dot(world), Up.Dot(world));

    private static bool IsUnit(Vector3D vector) => Math.Abs(vector.Length - 1) <= OrthonormalTolerance;
}
