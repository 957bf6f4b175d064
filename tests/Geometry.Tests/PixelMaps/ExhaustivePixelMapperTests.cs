using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.PixelMaps;

public sealed class ExhaustivePixelMapperTests
{
    private static readonly Camera Camera = new(
        new Pose(Vector3D.Zero, Axes.Identity),
        new CameraIntrinsics(90, new ImageSize(40, 30), 4.0 / 3, 0.1, Lens.Ideal)
    );

    [Fact]
    public void Map_plate_covers_the_pixels_whose_centres_it_covers()
    {
        // fx = fy = 15. A plate at depth 15 covers u = 20 + x, v = 15 - z: x 1..4, z 2..5 is columns 21..23, rows 10..12.
        var plate = new Cuboid(new(2.5, 15, 3.5), new(1.5, 0, 1.5), Axes.Identity);
        var world = new CuboidWorld([(42, plate)]);

        InstanceMap map = ExhaustivePixelMapper.Map(Camera, Camera.Image.Bounds, entity => entity == 42 ? (ushort)3 : (ushort)0, 0, world);

        Assert.Equal(new Box2D(21, 10, 24, 13), map.BoundsOf(3));
        Assert.Equal(9, map.MapOf(3).Count);
        Assert.Null(map.BoundsOf(4));
        Assert.Equal(1200, world.RaysCast);
    }

    [Fact]
    public void Map_nearer_entity_occludes_and_the_world_has_no_id()
    {
        var wide = new Cuboid(new(0, 15, 0), new(4, 0, 4), Axes.Identity);
        var near = new Cuboid(new(-50, 10, 0), new(50, 0, 50), Axes.Identity);

        InstanceMap hidden = ExhaustivePixelMapper.Map(
            Camera,
            Camera.Image.Bounds,
            entity => (ushort)entity,
            0,
            new CuboidWorld([(1, wide), (RayHit.World, near)])
        );
        InstanceMap ignored = ExhaustivePixelMapper.Map(
            Camera,
            Camera.Image.Bounds,
            entity => (ushort)entity,
            2,
            new CuboidWorld([(1, wide), (2, near)])
        );

        Assert.Equal(32, hidden.MapOf(1).Count);
        Assert.Equal(64, ignored.MapOf(1).Count);
        Assert.DoesNotContain(hidden.Ids, id => id > 1);
    }

    [Fact]
    public void Map_casts_only_within_the_region()
    {
        var world = new CuboidWorld([]);

        ExhaustivePixelMapper.Map(Camera, new Box2D(-5, 2.2, 3, 5.6), _ => 1, 0, world);

        // Columns 0..2, rows whose centres 2.5, 3.5, 4.5, 5.5 lie within 2.2..5.6.
        Assert.Equal(12, world.RaysCast);
    }
}
