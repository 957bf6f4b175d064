using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;

namespace Harvester.Geometry.Tests.PixelMaps;

public sealed class AdaptivePixelMapperTests
{
    private static readonly ImageSize Size = new(800, 600);

    [Fact]
    public void Run_does_not_depend_on_the_order_of_targets()
    {
        TownScene scene = TownScene.Numbered(17, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMap before = MapRun.Complete(scene, targets);
        MapTarget[] shuffled = [.. targets];
        new Random(1).Shuffle(shuffled);

        AdaptivePixelMap after = MapRun.Complete(scene, shuffled);

        Assert.Equal(before.Map.Ids, after.Map.Ids);
        Assert.Equal(before.RaysCast, after.RaysCast);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Run_ids_of_the_targets_change_only_the_ids()
    {
        TownScene scene = TownScene.Numbered(17, Size);
        List<MapTarget> targets = scene.Targets();
        AdaptivePixelMap before = MapRun.Complete(scene, targets);

        AdaptivePixelMap after = MapRun.Complete(scene, [.. targets.Select(t => t with { Number = (ushort)(1000 - t.Number) })]);

        Assert.Equal(before.Map.Ids, after.Map.Ids.Select(id => id == 0 ? (ushort)0 : (ushort)(1000 - id)));
    }

    [Fact]
    public void AdaptivePixelMapper_invalid_input_is_refused()
    {
        var car = new Cuboid(new(0, 20, 0), new(2, 1, 1), Axes.Identity);
        var world = new CuboidWorld([]);
        Assert.Throws<ArgumentException>(() =>
            MapRun.Complete(SmallWorld.Camera, world, [SmallWorld.Target(5, 1, car), SmallWorld.Target(6, 1, car)])
        );
        Assert.Throws<ArgumentException>(() =>
            MapRun.Complete(SmallWorld.Camera, world, [SmallWorld.Target(5, 1, car), SmallWorld.Target(5, 2, car)])
        );
        Assert.Throws<ArgumentException>(() => MapRun.Complete(SmallWorld.Camera, world, [SmallWorld.Target(5, 0, car)]));
        Assert.Throws<ArgumentOutOfRangeException>(() =>
            new AdaptivePixelMapper(SmallWorld.Camera, [], 0, world, new PixelMapOptions { RayBudget = -1 })
        );
        Assert.Throws<ArgumentOutOfRangeException>(() =>
            new AdaptivePixelMapper(SmallWorld.Camera, [], 0, world, new PixelMapOptions { CellErrorFraction = double.NaN })
        );
        Assert.Throws<ArgumentNullException>(() => new AdaptivePixelMapper(SmallWorld.Camera, [], 0, null!, new PixelMapOptions()));
    }
}
