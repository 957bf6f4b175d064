using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Depth;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>
/// Makes the depth maps of a frame: the sparse one from the frame's rays and further ones of its own, and with a mask the completed one.
/// </summary>
internal sealed class DepthLabeller(FrameRays rays) : IChannelLabeller
{
    /// <summary>Maximum rays of a depth map, as a fraction of the pixels.</summary>
    private const double MaxRayFraction = 0.03;

    /// <summary>A ray this close to the centre of a pixel, in pixels, passes through it.</summary>
    private const double CentreTolerance = 1e-6;

    /// <inheritdoc />
    public ChannelTurn Turn => ChannelTurn.Last;

    /// <inheritdoc />
    public string RaysKey => "depth";

    /// <inheritdoc />
    public IEnumerable<bool> Label(FrameDraft draft, Func<bool> mayCastRays)
    {
        Camera camera = draft.Camera;
        Dictionary<int, ushort> regions = RegionsOf(draft);
        int budget = Math.Min(rays.Left, (int)(MaxRayFraction * camera.Image.PixelCount));
        var grid = new DepthGrid(camera.Image, LinesOf(camera.Intrinsics)) { Regions = draft.Mask?.Ids };
        var mapper = new DepthMapper(grid, SampleAt, budget);
        var sparse = new InstanceMap(camera.Image);
        foreach (RecordedHit hit in rays.Record!.Hits.ToArray())
        {
            if (hit.Ray.Origin != camera.Pose.Position)
            {
                continue;
            }

            Vector3D place = hit.Ray.At(hit.Distance);
            Projection seen = camera.Project(place);
            if (seen.Outcome == ProjectionOutcome.InImage)
            {
                (int column, int row) = ((int)seen.U, (int)seen.V);
                Measure(sparse, column, row, seen.Depth);
                if (Math.Abs(seen.U - column - 0.5) < CentreTolerance && Math.Abs(seen.V - row - 0.5) < CentreTolerance)
                {
                    mapper.Know(column, row, SampleOf(camera.Pose.ToLocal(place), camera.Pose.Axes.ToLocal(hit.Normal), hit.Entity));
                }
            }
        }

        while (mayCastRays() && mapper.Step())
        {
            yield return true;
        }

        foreach (KeyValuePair<int, DepthSample> sample in mapper.Samples)
        {
            Measure(sparse, sample.Key % camera.Image.Width, sample.Key / camera.Image.Width, sample.Value.Depth);
        }

        DepthMap completed = mapper.Complete();
        bool hasMask = draft.Mask is not null;
        draft.Add(new DepthMaps(
            sparse,
            hasMask ? Units(completed, completed.Metres, DepthUnits.OfDepth) : null,
            hasMask ? Units(completed, completed.ErrorMetres, DepthUnits.OfError) : null,
            mapper.RaysCast)
        {
            Estimate = completed,
        });

        DepthSample SampleAt(int column, int row)
        {
            Ray ray = camera.RayThrough(column + 0.5, row + 0.5);
            RayHit? hit = rays.Cast(ray, ExhaustivePixelMapper.RayLength, draft.Snapshot.Ego.Handle, out Vector3D normal);
            return hit is { } met
                ? SampleOf(camera.Pose.ToLocal(ray.At(met.Distance)), camera.Pose.Axes.ToLocal(normal), met.Entity)
                : new DepthSample(double.PositiveInfinity, default, RayHit.World, 0);
        }

        DepthSample SampleOf(Vector3D point, Vector3D normal, int entity) =>
            new(point.Y, SurfacePlane.Of(point, normal), entity, regions.TryGetValue(entity, out ushort region) ? region : (ushort)0);
    }

    /// <summary>The line of sight of each pixel's centre. Without distortion, columns and rows are independent.</summary>
    private static Func<int, int, SightLine> LinesOf(CameraIntrinsics intrinsics)
    {
        if (intrinsics.Lens is not { K1: 0, K2: 0 })
        {
            return (column, row) => Line(column, row);
        }

        double[] across = [.. Enumerable.Range(0, intrinsics.Image.Width).Select(column => Line(column, 0).Direction.X)];
        double[] up = [.. Enumerable.Range(0, intrinsics.Image.Height).Select(row => Line(0, row).Direction.Z)];
        return (column, row) => new SightLine(new Vector3D(across[column], 1, up[row]));

        SightLine Line(int column, int row)
        {
            var shown = new Vector2D((column + 0.5 - intrinsics.Cx) / intrinsics.Fx, (row + 0.5 - intrinsics.Cy) / intrinsics.Fy);
            Vector2D ideal = intrinsics.Lens.Undistort(shown);
            return new SightLine(new Vector3D(ideal.X, 1, -ideal.Y));
        }
    }

    /// <summary>The number in the mask of each entity that it shows.</summary>
    private static Dictionary<int, ushort> RegionsOf(FrameDraft draft)
    {
        var shown = new HashSet<int>(draft.Mask is null ? [] : draft.Objects.Select(label => label.Id));
        return draft.Ids.Where(pair => shown.Contains(pair.Value)).ToDictionary(pair => pair.Key, pair => (ushort)pair.Value);
    }

    /// <summary>Enters a measured depth; of several in a pixel, the nearest counts.</summary>
    private static void Measure(InstanceMap sparse, int column, int row, double metres)
    {
        ushort depth = DepthUnits.OfDepth(metres);
        ushort known = sparse[column, row];
        sparse[column, row] = known == 0 || (depth != 0 && depth < known) ? depth : known;
    }

    private static InstanceMap Units(DepthMap map, double[] values, Func<double, ushort> unitsOf)
    {
        var units = new InstanceMap(map.Image);
        for (int i = 0; i < values.Length; i++)
        {
            units.Ids[i] = DepthUnits.OfDepth(map.Metres[i]) == 0 ? (ushort)0 : unitsOf(values[i]);
        }

        return units;
    }
}
