using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Motion;

/// <summary>
/// Where the points of one body, seen in one picture, are in the frame of another camera at another time. A point at depth d on the line of
/// sight l is d · R l + t there, and has moved by d · A l + b, because every step on the way is affine.
/// </summary>
internal sealed class PixelTransform
{
    /// <summary>Displacement in the world that counts as motion, metres: in games, parked vehicles tremble by less.</summary>
    private const double MovedMetres = 0.01;

    private readonly Vector3D _right,
        _forward,
        _up,
        _origin;
    private readonly Vector3D _movedRight,
        _movedForward,
        _movedUp,
        _movedOrigin;

    /// <summary>Joins the way through the world.</summary>
    /// <param name="from">The camera of the pixel's picture.</param>
    /// <param name="to">The camera of the other picture.</param>
    /// <param name="motion">The motion of the body.</param>
    public PixelTransform(Camera from, Camera to, BodyMotion motion)
    {
        Kind = motion.Kind;
        if (Kind is BodyMotionKind.Person or BodyMotionKind.Unknown)
        {
            return;
        }

        // The images of the origin and of the three unit vectors give the translation and the columns of the matrix.
        (_origin, _movedOrigin) = Map(Vector3D.Zero);
        (_right, _movedRight) = Column(new Vector3D(1, 0, 0));
        (_forward, _movedForward) = Column(new Vector3D(0, 1, 0));
        (_up, _movedUp) = Column(new Vector3D(0, 0, 1));

        (Vector3D, Vector3D) Column(Vector3D axis)
        {
            (Vector3D seen, Vector3D moved) = Map(axis);
            return (seen - _origin, moved - _movedOrigin);
        }

        (Vector3D Seen, Vector3D Moved) Map(Vector3D point)
        {
            Vector3D before = from.Pose.ToWorld(point);
            Vector3D after = motion.Kind == BodyMotionKind.Static ? before : motion.To.ToWorld(motion.From.ToLocal(before));
            return (to.Pose.ToLocal(after), from.Pose.Axes.ToLocal(after - before));
        }
    }

    /// <summary>How the body moves.</summary>
    public BodyMotionKind Kind { get; }

    /// <summary>The translation t.</summary>
    public Vector3D Translation => _origin;

    /// <summary>R l for a line of sight (right, 1, up).</summary>
    public Vector3D Direction(double right, double up) =>
        new(
            (_right.X * right) + _forward.X + (_up.X * up),
            (_right.Y * right) + _forward.Y + (_up.Y * up),
            (_right.Z * right) + _forward.Z + (_up.Z * up)
        );

    /// <summary>How far a point has moved, metres, along the axes of the pixel's camera: from the pixel's moment to the other.</summary>
    public Vector3D Displacement(double right, double up, double depth) =>
        Kind == BodyMotionKind.Static ? Vector3D.Zero : (((_movedRight * right) + _movedForward + (_movedUp * up)) * depth) + _movedOrigin;

    /// <summary>Whether a displacement counts as motion.</summary>
    public static bool IsMotion(Vector3D displacement) => displacement.LengthSquared > MovedMetres * MovedMetres;
}
