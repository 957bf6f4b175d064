using Harvester.Geometry;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>The rigid motion from a frame to the one that a record's fields translation and rotation refer to.</summary>
internal sealed class NuScenesMotion
{
    private readonly Vector3D _x;
    private readonly Vector3D _y;
    private readonly Vector3D _z;
    private readonly Vector3D _translation;

    /// <summary>Reads the fields. The rotation is a quaternion w, x, y, z, which is normalised.</summary>
    public NuScenesMotion(JsonFields record)
    {
        double[] place = record.Numbers("translation", 3);
        double[] q = record.Numbers("rotation", 4);
        _translation = new Vector3D(place[0], place[1], place[2]);
        double length = Math.Sqrt((q[0] * q[0]) + (q[1] * q[1]) + (q[2] * q[2]) + (q[3] * q[3]));
        (double w, double x, double y, double z) = (q[0] / length, q[1] / length, q[2] / length, q[3] / length);

        // The columns of the rotation matrix of a unit quaternion.
        _x = new Vector3D(1 - (2 * ((y * y) + (z * z))), 2 * ((x * y) + (w * z)), 2 * ((x * z) - (w * y)));
        _y = new Vector3D(2 * ((x * y) - (w * z)), 1 - (2 * ((x * x) + (z * z))), 2 * ((y * z) + (w * x)));
        _z = new Vector3D(2 * ((x * z) + (w * y)), 2 * ((y * z) - (w * x)), 1 - (2 * ((x * x) + (y * y))));
    }

    /// <summary>The x axis of the frame.</summary>
    public Vector3D Forward => _x;

    /// <summary>The z axis of the frame.</summary>
    public Vector3D Up => _z;

    /// <summary>The origin of the frame.</summary>
    public Vector3D Origin => _translation;

    /// <summary>A point of the frame in the other one.</summary>
    public Vector3D Apply(Vector3D point) => (_x * point.X) + (_y * point.Y) + (_z * point.Z) + _translation;

    /// <summary>A point of the other frame in this one.</summary>
    public Vector3D Invert(Vector3D point)
    {
        Vector3D from = point - _translation;
        return new Vector3D(_x.Dot(from), _y.Dot(from), _z.Dot(from));
    }
}
