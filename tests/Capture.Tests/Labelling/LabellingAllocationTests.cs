using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>What labelling allocates may not grow: it works in the game's process.</summary>
public sealed class LabellingAllocationTests : IRayCaster
{
    /// <summary>Of an object in the image: cuboid, projection, silhouette, label, and its places in lists and dictionaries.</summary>
    private const long MaxBytesPerLabel = 1_400;

    /// <summary>Of an object out of view: its cuboid.</summary>
    private const long MaxBytesPerObjectOutOfView = 150;

    /// <summary>Of a frame: camera, lists, and the iterator.</summary>
    private const long MaxBytesPerFrame = 3_000;

    [Theory]
    [InlineData(10)]
    [InlineData(100)]
    [InlineData(1000)]
    public void Labelling_allocates_in_proportion_to_the_objects(int count)
    {
        Assert.InRange(BytesOf(count, 60), 0, MaxBytesPerFrame + (count * MaxBytesPerLabel));
    }

    [Fact]
    public void Object_out_of_view_costs_hardly_more_than_its_cuboid()
    {
        Assert.InRange(BytesOf(1000, -60), 0, MaxBytesPerFrame + (1000 * MaxBytesPerObjectOutOfView));
    }

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => throw new InvalidOperationException("No ray may be cast.");

    private long BytesOf(int count, double north)
    {
        var options = new HarvestOptions { RangeMetres = 200 };
        SceneSnapshot snapshot = Scene(count, north);
        var registry = new ObjectRegistry(1);
        var labeller = new FrameLabeller(options, new FrameRays(this, 0), registry);
        Assert.Equal(north > 0 ? count : 0, Label().Objects.Count);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Label();
        return GC.GetAllocatedBytesForCurrentThread() - before;

        FrameDraft Label() => labeller.LabelAtOnce(snapshot, static () => false);
    }

    /// <summary>Cars side by side in rows, all in view of a camera at the origin that looks north, or all behind it.</summary>
    private static SceneSnapshot Scene(int count, double north) =>
        new(
            1,
            0,
            new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 60, 0.15, 4.0 / 3),
            new EgoState(1, "ego", default, default),
            [
                .. Enumerable
                    .Range(0, count)
                    .Select(i => new EntityState(
                        i + 2,
                        ObjectClass.Car,
                        "box",
                        new Pose(new Vector3D((i % 20) - 10, north * (1 + (i / 20 / 50.0)), 0), Axes.Identity),
                        new Vector3D(-1, 0, -1),
                        new Vector3D(1, 2, 1),
                        new Vector3D(0, 3, 0)
                    )),
            ],
            new EnvironmentState("clear", TimeSpan.Zero)
        );
}
