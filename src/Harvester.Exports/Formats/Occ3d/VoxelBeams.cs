using Harvester.Geometry;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Lidar;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>The voxels through which the beams of LiDARs pass, from the sensor to the points that they measured.</summary>
/// <param name="shape">The size of the box of voxels.</param>
/// <param name="origin">The origin of its frame in the frame of the vehicle's model (x right, y forward, z up), metres.</param>
internal sealed class VoxelBeams(VoxelShape shape, Vector3D origin)
{
    private readonly int[] _counts = [shape.Cells, shape.Cells, shape.Layers];

    /// <summary>1 where a beam passes or ends, else 0, by x forward, y to the left and z up.</summary>
    public byte[] Passed { get; } = new byte[shape.Count];

    /// <summary>Adds the beams of a LiDAR that have met something.</summary>
    /// <param name="sensor">Its pose in the frame of the vehicle's model.</param>
    /// <param name="points">What it measured, in its own frame.</param>
    public void Add(Pose sensor, IEnumerable<LidarPoint> points)
    {
        double[] from = PlaceOf(sensor.Position);
        foreach (LidarPoint point in points)
        {
            Add(from, PlaceOf(sensor.ToWorld(new Vector3D(point.X, point.Y, point.Z))));
        }
    }

    /// <summary>Where a point of the vehicle's model is among the voxels: a voxel's middle is at its numbers and a half.</summary>
    private double[] PlaceOf(Vector3D point)
    {
        Vector3D local = point - origin;
        double half = shape.Cells / 2.0;
        return
        [
            half + (local.Y / shape.CellMetres),
            half - (local.X / shape.CellMetres),
            (local.Z - shape.LowestMetres) / shape.CellMetres,
        ];
    }

    /// <summary>
    /// Goes from voxel to voxel along a beam, always through the nearest side (Amanatides and Woo, "A Fast Voxel Traversal Algorithm for
    /// Ray Tracing", 1987).
    /// </summary>
    private void Add(ReadOnlySpan<double> from, ReadOnlySpan<double> to)
    {
        // The part of the beam that is in the box, as fractions of its length: within the slabs of all three axes.
        (double enter, double leave) = (0, 1);
        Span<double> way = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
        for (int axis = 0; axis < way.Length; axis++)
        {
            double low = -from[axis] / way[axis];
            double high = (_counts[axis] - from[axis]) / way[axis];
            if (way[axis] == 0)
            {
                leave = from[axis] >= 0 && from[axis] < _counts[axis] ? leave : -1;
            }
            else
            {
                enter = Math.Max(enter, Math.Min(low, high));
                leave = Math.Min(leave, Math.Max(low, high));
            }
        }

        if (!(enter <= leave))
        {
            return;
        }

        Span<int> voxel = stackalloc int[way.Length];
        for (int axis = 0; axis < voxel.Length; axis++)
        {
            voxel[axis] = Math.Clamp((int)Math.Floor(from[axis] + (enter * way[axis])), 0, _counts[axis] - 1);
        }

        while (true)
        {
            Passed[(((voxel[0] * _counts[1]) + voxel[1]) * _counts[2]) + voxel[2]] = 1;

            // The beam leaves the voxel where the first of the three sides ahead is: at the fraction (side - from) / way.
            (int next, double nearest) = (0, double.PositiveInfinity);
            for (int axis = 0; axis < way.Length; axis++)
            {
                if (way[axis] != 0)
                {
                    double at = (voxel[axis] + (way[axis] > 0 ? 1 : 0) - from[axis]) / way[axis];
                    (next, nearest) = at < nearest ? (axis, at) : (next, nearest);
                }
            }

            if (nearest > leave)
            {
                return;
            }

            voxel[next] += Math.Sign(way[next]);
            if (voxel[next] < 0 || voxel[next] >= _counts[next])
            {
                return;
            }
        }
    }
}
