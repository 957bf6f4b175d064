using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Depth;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;

namespace Harvester.Capture.Labelling;

/// <summary>
/// The surfaces in a frame, sampled by rays: those of the frame that were cast before, and further ones where they are too few.
/// </summary>
internal sealed class FrameSurfaces
{
    /// <summary>Maximum further rays, as a fraction of the pixels.</summary>
    private const double MaxRayFraction = 0.03;

    /// <summary>A ray this close to the centre of a pixel, in pixels, passes through it.</summary>
    private const double CentreTolerance = 1e-6;

    private readonly FrameRays _rays;
    private readonly FrameDraft _draft;
    private readonly Dictionary<int, ushort> _regions;
    private readonly DepthMapper _mapper;
    private readonly List<(int Column, int Row, double Depth)> _hits = [];

    /// <summary>Takes what the rays of a frame have hit so far.</summary>
    /// <param name="rays">The rays of the frame, which are recorded.</param>
    /// <param name="draft">The frame with its mask.</param>
    public FrameSurfaces(FrameRays rays, FrameDraft draft)
    {
        (_rays, _draft) = (rays, draft);
        _regions = RegionsOf(draft);
        Camera camera = draft.Camera;
        int budget = Math.Min(rays.Left, (int)(MaxRayFraction * camera.Image.PixelCount));
        _mapper = new DepthMapper(new DepthGrid(camera.Image, LinesOf(camera.Intrinsics)) { Regions = draft.Mask?.Ids }, SampleAt, budget);
        foreach (RecordedHit hit in rays.Record!.Hits.ToArray())
        {
            if (hit.Ray.Origin == camera.Pose.Position)
            {
                Take(camera, hit);
            }
        }
    }

    /// <summary>Where earlier rays hit, with the depth along the camera's axis, metres.</summary>
    public IReadOnlyList<(int Column, int Row, double Depth)> Hits => _hits;

    /// <summary>The samples at centres of pixels, by the number of the pixel, row by row.</summary>
    public IReadOnlyDictionary<int, DepthSample> Samples => _mapper.Samples;

    /// <summary>The number of further rays so far.</summary>
    public int RaysCast => _mapper.RaysCast;

    /// <summary>Casts further rays, in steps.</summary>
    /// <param name="mayCastRays">Called before each part.</param>
    public IEnumerable<WorkStep> Sample(Func<bool> mayCastRays)
    {
        while (mayCastRays() && _mapper.Step())
        {
            yield return WorkStep.Pause;
        }
    }

    /// <summary>The depths of all pixels, and the sample that each is taken from.</summary>
    public DepthMap Complete() => _mapper.Complete();

    private void Take(Camera camera, RecordedHit hit)
    {
        Vector3D place = hit.Ray.At(hit.Distance);
        Projection seen = camera.Project(place);
        if (seen.Outcome != ProjectionOutcome.InImage)
        {
            return;
        }

        (int column, int row) = ((int)seen.U, (int)seen.V);
        _hits.Add((column, row, seen.Depth));
        if (Math.Abs(seen.U - column - 0.5) < CentreTolerance && Math.Abs(seen.V - row - 0.5) < CentreTolerance)
        {
            _mapper.Know(column, row, SampleOf(camera.Pose.ToLocal(place), camera.Pose.Axes.ToLocal(hit.Normal), hit.Entity));
        }
    }

    private DepthSample SampleAt(int column, int row)
    {
        Camera camera = _draft.Camera;
        Ray ray = camera.RayThrough(column + 0.5, row + 0.5);
        RayHit? hit = _rays.Cast(ray, ExhaustivePixelMapper.RayLength, _draft.Snapshot.Ego.Handle, out Vector3D normal);
        return hit is { } met
            ? SampleOf(camera.Pose.ToLocal(ray.At(met.Distance)), camera.Pose.Axes.ToLocal(normal), met.Entity)
            : new DepthSample(double.PositiveInfinity, default, RayHit.World, 0);
    }

    private DepthSample SampleOf(Vector3D point, Vector3D normal, int entity) =>
        new(point.Y, SurfacePlane.Of(point, normal), entity, _regions.TryGetValue(entity, out ushort region) ? region : (ushort)0);

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
}
