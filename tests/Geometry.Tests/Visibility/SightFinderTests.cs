using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;

namespace Harvester.Geometry.Tests.Visibility;

public sealed class SightFinderTests
{
    private const int Car = 7;
    private const int Ego = 8;

    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity),
        new CameraIntrinsics(90, new ImageSize(800, 600), 4.0 / 3, 0.1, Lens.Ideal)
    );

    private static readonly Cuboid Target = new(new(0, 20, 0), new(2, 2, 2), Axes.Identity);
    private static readonly Cuboid Wall = new(new(0, 10, 0), new(50, 0.1, 50), Axes.Identity);

    [Fact]
    public void Object_with_nothing_in_front_is_seen_by_one_ray()
    {
        var world = new CuboidWorld([(Car, Target)]);

        Assert.Equal(Sight.Seen, Find(Target, world));
        Assert.Equal(1, world.RaysCast);
    }

    [Fact]
    public void Object_behind_a_wall_is_unseen_by_few_rays()
    {
        var world = new CuboidWorld([(Car, Target), (RayHit.World, Wall)]);

        Assert.Equal(Sight.Unseen, Find(Target, world));
        Assert.Equal(8, world.RaysCast);
    }

    [Fact]
    public void Small_object_behind_one_wall_is_unseen_by_four_rays()
    {
        // 4 m at 180 m are 9 x 9 pixels, fewer than four times 32.
        Cuboid small = new(new(0, 180, 0), new(2, 2, 2), Axes.Identity);
        var world = new CuboidWorld([(Car, small), (RayHit.World, Wall)]);

        Assert.Equal(Sight.Unseen, Find(small, world));
        Assert.Equal(4, world.RaysCast);
    }

    [Fact]
    public void Object_in_a_corner_of_its_cuboid_that_is_covered_is_unseen()
    {
        // The wall covers the image's left half and so all of the object, but only half of its cuboid.
        Cuboid leftEdge = new(new(-1.5, 20, 0), new(0.5, 2, 2), Axes.Identity);
        Cuboid leftWall = new(new(-50, 10, 0), new(50, 0.1, 50), Axes.Identity);

        Assert.Equal(Sight.Unseen, Find(Target, new CuboidWorld([(Car, leftEdge), (RayHit.World, leftWall)])));
    }

    [Fact]
    public void Object_that_no_ray_hits_is_undetermined() => Assert.Equal(Sight.Undetermined, Find(Target, new CuboidWorld([])));

    [Fact]
    public void Object_whose_visible_part_is_empty_is_unseen()
    {
        // The image ends at x = y · 4/3 to the right. The cuboid reaches from x = 24 to 44 at 20 to 24 m; the object fills its right end,
        // outside.
        Cuboid wide = new(new(34, 22, 0), new(10, 2, 2), Axes.Identity);
        Cuboid rightEnd = new(new(43, 22, 0), new(1, 2, 2), Axes.Identity);

        Assert.Equal(Sight.Unseen, Find(wide, new CuboidWorld([(Car, rightEnd)])));
    }

    [Fact]
    public void No_step_casts_more_rays_than_it_may()
    {
        var world = new CuboidWorld([]);
        CuboidProjection projection = CuboidProjector.Project(Camera, Target);
        int most = 0;
        int before = 0;
        using var run = new WorkRun(
            SightFinder.FindInSteps(Camera, Target, projection, Car, Ego, world, new WorkResult<Sight>()),
            static () => true
        );
        for (bool isLeft = true; isLeft; before = world.RaysCast)
        {
            isLeft = run.Advance();
            most = Math.Max(most, world.RaysCast - before);
        }

        Assert.Equal(OcclusionEstimator.RaysOfAStep, most);
        Assert.Equal(SightFinder.MaxRays, before);
    }

    [Fact]
    public void Object_behind_the_camera_is_unseen() =>
        Assert.Equal(Sight.Unseen, Find(new(new(0, -20, 0), new(2, 2, 2), Axes.Identity), new CuboidWorld([])));

    private static Sight Find(Cuboid cuboid, CuboidWorld world) =>
        SightFinder.Find(Camera, cuboid, CuboidProjector.Project(Camera, cuboid), Car, Ego, world);
}
