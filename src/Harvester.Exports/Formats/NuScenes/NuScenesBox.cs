using Harvester.Geometry;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>A box in the global frame, as the fields of an annotation give it: size is width, length, height.</summary>
internal sealed class NuScenesBox
{
    private readonly NuScenesMotion _motion;
    private readonly Vector3D _half;
    private readonly double _radius;

    /// <summary>Reads the fields translation, size and rotation.</summary>
    public NuScenesBox(JsonFields record)
    {
        double[] size = record.Numbers("size", 3);
        _motion = new NuScenesMotion(record);
        _half = new Vector3D(size[1] / 2, size[0] / 2, size[2] / 2);
        _radius = _half.Length;
    }

    /// <summary>Its centre, metres.</summary>
    public Vector3D Centre => _motion.Origin;

    /// <summary>Its x axis, along its length.</summary>
    public Vector3D Forward => _motion.Forward;

    /// <summary>Its z axis, along its height.</summary>
    public Vector3D Up => _motion.Up;

    /// <summary>Its corners, metres.</summary>
    public IEnumerable<Vector3D> Corners =>
        from x in (double[])[-1, 1]
        from y in (double[])[-1, 1]
        from z in (double[])[-1, 1]
        select _motion.Apply(new Vector3D(x * _half.X, y * _half.Y, z * _half.Z));

    /// <summary>The number of points inside or on its faces, as points_in_box of nuScenes' devkit has it.</summary>
    /// <param name="points">Points, metres, global.</param>
    public int Count(IEnumerable<Vector3D> points) => points.Count(IsInside);

    private bool IsInside(Vector3D point)
    {
        if (Math.Abs(point.X - Centre.X) > _radius || Math.Abs(point.Y - Centre.Y) > _radius)
        {
            return false;
        }

        Vector3D local = _motion.Invert(point);
        return Math.Abs(local.X) <= _half.X && Math.Abs(local.Y) <= _half.Y && Math.Abs(local.Z) <= _half.Z;
    }
}
