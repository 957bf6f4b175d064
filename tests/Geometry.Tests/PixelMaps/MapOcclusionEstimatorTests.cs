using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.PixelMaps;

public sealed class MapOcclusionEstimatorTests
{
    private const int Car = 7;

    /// <summary>64 probes of the pixels that do not show the object.</summary>
    private const double SamplingError = 0.03;

    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity),
        new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.1, Lens.Ideal)
    );

    private static readonly Cuboid Target = new(new(0, 20, 0), new(2, 2, 2), Axes.Identity);

    /// <summary>From far left to the plane x = 0: exactly the image's left half.</summary>
    private static readonly (int, Cuboid) WallOnTheLeft = (RayHit.World, new(new(-50, 10, 0), new(50, 0.1, 50), Axes.Identity));

    [Fact]
    public void Estimate_wall_over_the_left_half_hides_half()
    {
        OcclusionEstimate estimate = Estimate([(Car, Target), WallOnTheLeft], Sight.Seen);

        Assert.Equal(0.5, estimate.OccludedFraction, SamplingError);
        Assert.Equal(OcclusionMethod.PixelMap, estimate.Method);
    }

    [Fact]
    public void Estimate_gaps_between_cuboid_and_object_do_not_count()
    {
        Cuboid rightHalf = new(new(1, 20, 0), new(1, 2, 2), Axes.Identity);

        Assert.Equal(0, Estimate([(Car, rightHalf), WallOnTheLeft], Sight.Seen).OccludedFraction, SamplingError);
    }

    [Fact]
    public void Estimate_of_a_fully_hidden_object_is_1()
    {
        OcclusionEstimate estimate = Estimate(
            [(Car, Target), (RayHit.World, new(new(0, 10, 0), new(50, 0.1, 50), Axes.Identity))],
            Sight.Unseen
        );

        Assert.Equal(1, estimate.OccludedFraction);
        Assert.Equal(0, estimate.SamplesOnObject);
    }

    [Fact]
    public void Estimate_of_a_hidden_object_takes_one_ray()
    {
        OcclusionEstimate estimate = Estimate(
            [(Car, Target), (RayHit.World, new(new(0, 10, 0), new(50, 0.1, 50), Axes.Identity))],
            Sight.Unseen
        );

        Assert.Equal((OcclusionMethod.PixelMap, Sight.Unseen, 1), (estimate.Method, estimate.Sight, estimate.RaysCast));
    }

    [Fact]
    public void Estimate_of_an_object_outside_the_image_has_no_occlusion()
    {
        OcclusionEstimate estimate = Estimate([], Sight.Unseen);

        Assert.Equal((OcclusionMethod.None, Sight.Unseen), (estimate.Method, estimate.Sight));
    }

    [Theory]
    [InlineData(Sight.NotAsked)]
    [InlineData(Sight.Undetermined)]
    public void Estimate_of_an_unknown_object_takes_no_rays(Sight sight) =>
        Assert.Equal(new OcclusionEstimate { Sight = sight }, Estimate([(Car, Target)], sight));

    private static OcclusionEstimate Estimate(IReadOnlyList<(int Entity, Cuboid Solid)> solids, Sight sight)
    {
        var world = new CuboidWorld(solids);
        InstanceMap map = ExhaustivePixelMapper.Map(
            Camera,
            Camera.Image.Bounds,
            entity => entity == Car ? (ushort)1 : (ushort)0,
            RayHit.World,
            world
        );
        var target = new MapTarget(Car, 1, Target, CuboidProjector.Project(Camera, Target));
        return new MapOcclusionEstimator(Camera, map, RayHit.World, world, 64).Estimate(target, sight);
    }
}
