using Harvester.Geometry;

namespace Harvester.Reports.Comparison;

/// <summary>A coordinate frame in another one: where its origin lies and how it is turned.</summary>
internal readonly struct RigidFrame
{
    private readonly Vector3D _origin;
    private readonly double _w;
    private readonly Vector3D _axis;

    /// <summary>A frame as nuScenes writes it.</summary>
    /// <param name="origin">Its origin in the outer frame.</param>
    /// <param name="quaternion">w, x, y, z; of any length greater than 0.</param>
    public RigidFrame(Vector3D origin, ReadOnlySpan<double> quaternion)
    {
        double length = Math.Sqrt(
            (quaternion[0] * quaternion[0])
                + (quaternion[1] * quaternion[1])
                + (quaternion[2] * quaternion[2])
                + (quaternion[3] * quaternion[3])
        );
        if (!(length > 0))
        {
            throw new ArgumentException("A rotation must not be all zeros.", nameof(quaternion));
        }

        _origin = origin;
        _w = quaternion[0] / length;
        _axis = new Vector3D(quaternion[1] / length, quaternion[2] / length, quaternion[3] / length);
    }

    /// <summary>A point of this frame in the outer one.</summary>
    public Vector3D ToOuter(Vector3D point) => Turned(point, _axis) + _origin;

    /// <summary>A point of the outer frame in this one.</summary>
    public Vector3D ToInner(Vector3D point) => Turned(point - _origin, -_axis);

    /// <summary>v + 2 w (q × v) + 2 q × (q × v), the rotation of v by the unit quaternion (w, q).</summary>
    private Vector3D Turned(Vector3D vector, Vector3D axis)
    {
        Vector3D across = axis.Cross(vector);
        return vector + (across * (2 * _w)) + (axis.Cross(across) * 2);
    }
}
