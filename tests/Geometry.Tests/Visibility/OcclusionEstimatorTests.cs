using FsCheck;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Geometry.Tests.Visibility;

public sealed class OcclusionEstimatorTests(ITestOutputHelper output)
{
    private const int Car = 7;
    private const int Ego = 8;

    /// <summary>256 well-spread samples: the R2 sequence is off by a few samples on a half plane.</summary>
    private const double SamplingError = 0.02;

    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity),
        new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.1, Lens.Ideal)
    );

    private static readonly Cuboid Target = new(new(0, 20, 0), new(2, 2, 2), Axes.Identity);

    [Fact]
    public void Estimate_nothing_in_front_is_not_occluded()
    {
        OcclusionEstimate estimate = Estimate([(Car, Target)]);

        Assert.Equal(0, estimate.OccludedFraction);
        Assert.Equal(OcclusionMethod.Rays, estimate.Method);

        // Six in sixteen of 256 are cast before an object that may be hidden counts as whole.
        Assert.Equal(96, estimate.SamplesOnObject);
        Assert.Equal(96, estimate.RaysCast);
    }

    [Fact]
    public void Estimate_of_what_nothing_overlaps_takes_fewer_rays()
    {
        var world = new CuboidWorld([(Car, Target)]);
        OcclusionEstimate estimate = new OcclusionEstimator(256).Estimate(
            Camera,
            Target,
            CuboidProjector.Project(Camera, Target),
            Car,
            Ego,
            world,
            isOverlapped: false
        );

        Assert.Equal((0, 48), (estimate.OccludedFraction, world.RaysCast));
    }

    [Fact]
    public void Estimate_object_behind_a_thing_inside_its_cuboid_is_hidden()
    {
        // The object is the rear of its cuboid; a part of the world stands in the front of the same cuboid and covers its right half.
        Cuboid rear = new(new(0, 21.5, 0), new(2, 0.5, 2), Axes.Identity);
        OcclusionEstimate estimate = Estimate([(Car, rear), (RayHit.World, new(new(5, 18.5, 0), new(5, 0.1, 5), Axes.Identity))]);

        Assert.Equal(0.5, estimate.OccludedFraction, SamplingError);
    }

    [Fact]
    public void Estimate_wall_over_the_left_half_hides_half()
    {
        // A wall at depth 10 from far left to the plane x = 0 covers exactly the image's left half.
        OcclusionEstimate estimate = Estimate([(Car, Target), (RayHit.World, new(new(-50, 10, 0), new(50, 0.1, 50), Axes.Identity))]);

        Assert.Equal(0.5, estimate.OccludedFraction, SamplingError);
        Assert.Equal(OcclusionMethod.Rays, estimate.Method);
    }

    [Fact]
    public void Estimate_behind_a_wall_is_all_hidden()
    {
        OcclusionEstimate estimate = Estimate([(Car, Target), (RayHit.World, new(new(0, 10, 0), new(50, 0.1, 50), Axes.Identity))]);

        Assert.Equal((1, OcclusionMethod.CuboidRays, Sight.Unseen), (estimate.OccludedFraction, estimate.Method, estimate.Sight));
    }

    [Fact]
    public void Estimate_behind_one_wall_takes_a_ray_for_16_pixels()
    {
        // The cuboid's front, 4 m wide and 78 m away, has 15 x 15 pixels, or 14 times 16.
        Cuboid far = new(new(0, 80, 0), new(2, 2, 2), Axes.Identity);
        var world = new CuboidWorld([(Car, far), (RayHit.World, new(new(0, 10, 0), new(50, 0.1, 50), Axes.Identity))]);
        OcclusionEstimate estimate = new OcclusionEstimator().Estimate(Camera, far, CuboidProjector.Project(Camera, far), Car, Ego, world);

        Assert.Equal(1, estimate.OccludedFraction);
        Assert.InRange(world.RaysCast, 12, 16);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.5)]
    public void Estimate_object_seen_through_a_gap_between_walls_is_seen(double step)
    {
        // Two walls at depths 10 and 10 + step, less than a tenth apart, leave a slit of 3 x 15 pixels, 46 in all, wherever it lies.
        const double slit = 0.1;
        Cuboid far = new(new(0, 80, 0), new(2, 2, 2), Axes.Identity);
        for (double left = -0.24; left <= 0.14; left += 0.02)
        {
            var world = new CuboidWorld([
                (Car, far),
                (RayHit.World, new(new(left - 50, 10, 0), new(50, 0.01, 50), Axes.Identity)),
                (RayHit.World, new(new(left + slit + 50, 10 + step, 0), new(50, 0.01, 50), Axes.Identity)),
            ]);
            CuboidProjection projection = CuboidProjector.Project(Camera, far);

            OcclusionEstimate estimate = new OcclusionEstimator().Estimate(Camera, far, projection, Car, Ego, world);

            Assert.Equal(Sight.Seen, estimate.Sight);
            Assert.InRange(estimate.OccludedFraction, 0.6, 0.95);
        }
    }

    [Fact]
    public void Estimate_ignored_entity_hides_nothing()
    {
        OcclusionEstimate estimate = Estimate([(Car, Target), (Ego, new(new(0, 5, 0), new(50, 0.1, 50), Axes.Identity))]);

        Assert.Equal(0, estimate.OccludedFraction);
    }

    [Fact]
    public void Estimate_gaps_between_cuboid_and_object_do_not_count()
    {
        // The object fills only the right half of its cuboid, and the wall hides only the left half.
        Cuboid rightHalf = new(new(1, 20, 0), new(1, 2, 2), Axes.Identity);
        OcclusionEstimate estimate = Estimate([(Car, rightHalf), (RayHit.World, new(new(-50, 10, 0), new(50, 0.1, 50), Axes.Identity))]);

        Assert.Equal(0, estimate.OccludedFraction);

        // Half of the 288 samples, an eighth more than asked for.
        Assert.InRange(estimate.SamplesOnObject, 140, 180);
    }

    [Fact]
    public void Estimate_entity_that_no_ray_hits_is_undetermined()
    {
        OcclusionEstimate estimate = Estimate([(RayHit.World, new(new(-50, 10, 0), new(50, 0.1, 50), Axes.Identity))]);

        Assert.Equal((OcclusionMethod.None, Sight.Undetermined), (estimate.Method, estimate.Sight));
    }

    [Fact]
    public void Estimate_entity_that_no_ray_hits_behind_a_wall_is_hidden()
    {
        OcclusionEstimate estimate = Estimate([(RayHit.World, new(new(0, 10, 0), new(50, 0.1, 50), Axes.Identity))]);

        Assert.Equal((1, OcclusionMethod.CuboidRays, Sight.Unseen), (estimate.OccludedFraction, estimate.Method, estimate.Sight));
    }

    [Fact]
    public void Estimate_thin_object_is_found_by_more_rays()
    {
        // A mast 2 cm wide in a cuboid of 4 m: one ray in 200 hits it.
        OcclusionEstimate estimate = Estimate([(Car, new(new(0.37, 20, 0), new(0.01, 2, 2), Axes.Identity))]);

        Assert.Equal((0, OcclusionMethod.Rays, Sight.Seen), (estimate.OccludedFraction, estimate.Method, estimate.Sight));
    }

    [Fact]
    public void Estimate_of_an_object_whose_visible_part_is_empty_is_unseen()
    {
        // The image ends at x = y · 4/3 to the right. The cuboid reaches from x = 24 to 44 at 20 to 24 m; the object fills its right end,
        // outside.
        Cuboid wide = new(new(34, 22, 0), new(10, 2, 2), Axes.Identity);
        Cuboid rightEnd = new(new(43, 22, 0), new(1, 2, 2), Axes.Identity);
        OcclusionEstimate estimate = new OcclusionEstimator().Estimate(
            Camera,
            wide,
            CuboidProjector.Project(Camera, wide),
            Car,
            Ego,
            new CuboidWorld([(Car, rightEnd)])
        );

        Assert.Equal((OcclusionMethod.None, Sight.Unseen), (estimate.Method, estimate.Sight));
    }

    [Fact]
    public void Estimate_is_nearer_than_as_many_rays_without_inference()
    {
        // With 36 samples, all cast, an estimate takes more rays than with 64, most of them inferred. 4000 samples are all pixels.
        const int castSamples = 36;
        const int pixels = 4000;
        double error = 0,
            plainError = 0;
        int cast = 0,
            plainCast = 0,
            partly = 0;
        var camera = new Camera(
            new Pose(new(0, -20, 0), Axes.Identity),
            new CameraIntrinsics(90, new ImageSize(200, 150), 4.0 / 3, 0.1, Lens.Ideal)
        );
        Arbitrary<Cuboid> solids = Draws.Cuboids(Draws.Vectors(8));
        RandomCases.Check(
            300,
            RandomCases.ArrayOf(solids, 4),
            drawn =>
            {
                // The object is a part of its cuboid, so that there are gaps; the others stand where they may hide it.
                Cuboid cuboid = drawn[0];
                Cuboid part = new(
                    cuboid.Centre + (cuboid.Axes.Right * (0.2 * cuboid.HalfExtents.X)),
                    cuboid.HalfExtents * 0.8,
                    cuboid.Axes
                );
                CuboidWorld NewWorld() => new([(Car, part), .. drawn.Skip(1).Select((solid, i) => (i + Ego + 1, solid))]);
                CuboidProjection projection = CuboidProjector.Project(camera, cuboid);
                CuboidWorld world = NewWorld();
                OcclusionEstimate estimate = new OcclusionEstimator().Estimate(camera, cuboid, projection, Car, Ego, world);
                var plain = new EveryRayOcclusion(NewWorld());
                OcclusionEstimate expected = plain.Estimate(camera, cuboid, projection, Car, Ego, castSamples);
                OcclusionEstimate exact = new EveryRayOcclusion(NewWorld()).Estimate(camera, cuboid, projection, Car, Ego, pixels);
                cast += world.RaysCast;
                plainCast += plain.RaysCast;
                if (exact.Method == OcclusionMethod.Rays)
                {
                    error += Math.Abs(FractionOf(estimate) - exact.OccludedFraction);
                    plainError += Math.Abs(FractionOf(expected) - exact.OccludedFraction);
                    partly += exact.OccludedFraction is > 0 and < 1 ? 1 : 0;
                }
            }
        );

        output.WriteLine($"{partly} partly hidden, error {error:F3} of {plainError:F3}, {cast} rays of {plainCast}");
        Assert.InRange(partly, 50, 300);
        Assert.InRange(error, 0, plainError);
        Assert.InRange(cast, 1, plainCast);
    }

    [Fact]
    public void No_step_casts_more_rays_than_it_may()
    {
        int most = 0;
        var camera = new Camera(new Pose(new(0, -20, 0), Axes.Identity), Camera.Intrinsics);
        RandomCases.Check(
            100,
            RandomCases.ArrayOf(Draws.Cuboids(Draws.Vectors(8)), 4),
            drawn =>
            {
                // The object is a part of its cuboid or, in every other case, not hit by rays at all.
                Cuboid part = new(drawn[0].Centre, drawn[0].HalfExtents * 0.6, drawn[0].Axes);
                int hit = drawn[0].Centre.X > 0 ? Car : RayHit.World;
                var world = new CuboidWorld([(hit, part), .. drawn.Skip(1).Select(solid => (RayHit.World, solid))]);
                CuboidProjection projection = CuboidProjector.Project(camera, drawn[0]);
                int before = 0;
                using var run = new WorkRun(
                    new OcclusionEstimator(32).EstimateInSteps(
                        camera,
                        drawn[0],
                        projection,
                        Car,
                        Ego,
                        world,
                        new WorkResult<OcclusionEstimate>()
                    ),
                    static () => true
                );
                for (bool isLeft = true; isLeft; before = world.RaysCast)
                {
                    isLeft = run.Advance();
                    most = Math.Max(most, world.RaysCast - before);
                }
            }
        );

        Assert.Equal(OcclusionEstimator.RaysOfAStep, most);
    }

    [Fact]
    public void Estimate_respects_its_ray_limit()
    {
        var estimator = new OcclusionEstimator(16);
        var world = new CuboidWorld([]);

        estimator.Estimate(Camera, Target, CuboidProjector.Project(Camera, Target), Car, Ego, world);

        Assert.InRange(world.RaysCast, 1, estimator.MaxRays);
    }

    [Fact]
    public void Estimate_behind_the_camera_is_unseen()
    {
        Cuboid behind = new(new(0, -20, 0), new(2, 2, 2), Axes.Identity);
        OcclusionEstimate estimate = new OcclusionEstimator().Estimate(
            Camera,
            behind,
            CuboidProjector.Project(Camera, behind),
            Car,
            Ego,
            new CuboidWorld([])
        );

        Assert.Equal(new OcclusionEstimate(0, 0, 0, OcclusionMethod.None) { Sight = Sight.Unseen }, estimate);
    }

    [Fact]
    public void OcclusionEstimator_invalid_input_is_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new OcclusionEstimator(0));
        Assert.Throws<ArgumentNullException>(() =>
            new OcclusionEstimator().Estimate(Camera, Target, CuboidProjector.Project(Camera, Target), Car, Ego, null!)
        );
    }

    /// <summary>The fraction, where an object that is not found counts as hidden.</summary>
    private static double FractionOf(OcclusionEstimate estimate) => estimate.Method == OcclusionMethod.None ? 1 : estimate.OccludedFraction;

    private static OcclusionEstimate Estimate(IReadOnlyList<(int Entity, Cuboid Solid)> solids)
    {
        var world = new CuboidWorld(solids);
        OcclusionEstimate estimate = new OcclusionEstimator(256).Estimate(
            Camera,
            Target,
            CuboidProjector.Project(Camera, Target),
            Car,
            Ego,
            world
        );
        Assert.Equal(world.RaysCast, estimate.RaysCast);
        return estimate;
    }
}
