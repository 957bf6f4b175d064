using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Calibration;

/// <summary>Sightings of a camera with a defect, fitted by a lens that cannot represent it.</summary>
public sealed class MisfitFinderTests
{
    private const double NoisePixels = 0.1;
    private static readonly Lens Injected = new(1.01, 0.004, -0.003, -0.02, 0.002);

    [Theory]
    [InlineData(Misfit.Noise, 0)]
    [InlineData(Misfit.Stretch, 0.01)]
    [InlineData(Misfit.CameraPosition, 0.01)]
    [InlineData(Misfit.CameraRoll, 0.01)]
    [InlineData(Misfit.LensShape, 0.02)]
    public void Cause_of_a_defect_is_named(Misfit defect, double size)
    {
        CameraIntrinsics intrinsics = new(60, new ImageSize(800, 600), 4.0 / 3, 0.1, Injected);
        List<Sighting> sightings = Sightings(intrinsics, defect, size);
        LensFit fit = LensFitter.Fit(intrinsics, sightings);

        var found = new CameraIntrinsics(60, intrinsics.Image, intrinsics.WindowAspect, 0.1, fit.Lens);

        Assert.Equal(defect, MisfitFinder.Of(found, sightings));
    }

    private static List<Sighting> Sightings(CameraIntrinsics intrinsics, Misfit defect, double size)
    {
        var random = new Random(3);
        var pose = new Pose(new Vector3D(1200, -340, 31), Axes.FromEuler(new EulerAngles(-3, 1, 77)));
        Camera ideal = new(pose, new CameraIntrinsics(60, intrinsics.Image, intrinsics.WindowAspect, 0.1, Lens.Ideal));
        IReadOnlyList<PlannedMarker> markers = MarkerPlan.Across(ideal, 15, 11, 6, [0.9, 1.2, 1.6]).Markers;
        return
        [
            .. markers.Select(marker =>
            {
                // What the true camera has to do with the point before the lens sees it.
                Vector3D local = pose.ToLocal(marker.Centre);
                double x = local.X / local.Y;
                double z = local.Z / local.Y;
                Vector3D seen = defect switch
                {
                    Misfit.Stretch => local with { X = local.X * (1 + size) },
                    Misfit.CameraPosition => local - new Vector3D(size, 0, 0),
                    Misfit.CameraRoll => new Vector3D(local.X - (size * local.Z), local.Y, local.Z + (size * local.X)),
                    Misfit.LensShape => new Vector3D(
                        local.X + (local.Y * 2 * size * x * z),
                        local.Y,
                        local.Z + (local.Y * size * ((x * x) + (3 * z * z)))
                    ),
                    _ => local,
                };
                Vector2D pixel = new Camera(pose, intrinsics).Project(pose.ToWorld(seen)).Pixel;
                return new Sighting(pose, marker.Centre, pixel + (new Vector2D(Normal(random), Normal(random)) * NoisePixels));
            }),
        ];
    }

    /// <summary>Box and Muller's normal variate.</summary>
    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
