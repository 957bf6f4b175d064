using System.Globalization;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Benchmarks.Figures;

/// <summary>What labels cost without rays: whole frames, made again from their scenes, and boxes alone.</summary>
internal static class LabellingFigures
{
    private static readonly ImageSize Size = new(800, 600);

    public static void Run()
    {
        foreach (int count in new[] { 10, 100, 1000 })
        {
            Frame(count);
        }

        Boxes(1000);
    }

    private static void Frame(int count)
    {
        var random = new Random(1);
        var options = new LabellingOptions { Image = Size };
        var camera = new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 50, 0.15, Size.Aspect);
        var ego = new EgoState(1, "ego", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero);
        EntityState[] entities =
        [
            .. Enumerable
                .Range(0, count)
                .Select(i => new EntityState(
                    i + 2,
                    ObjectClass.Car,
                    "car",
                    new Pose(InView(random), Axes.FromHeading(360 * random.NextDouble())),
                    new Vector3D(-1, -2.2, -0.8),
                    new Vector3D(1, 2.2, 0.8),
                    Vector3D.Zero
                )),
        ];
        var environment = new EnvironmentState("clear", TimeSpan.Zero);
        var scene = new RecordedScene(
            new SceneSnapshot(1, 0, camera, ego, entities, environment),
            options.Lens,
            new Dictionary<int, int>(),
            []
        );
        var recorded = new FrameLabel(
            1,
            1,
            0,
            0,
            0,
            "frames/00000001.png",
            null,
            CameraLabel.Of(Camera()),
            EgoLabel.Of(ego),
            environment,
            []
        );
        var labeller = new FrameRelabeller(options, options, new RecordedIds(), null);
        void Label()
        {
            if (labeller.Relabel(scene, recorded, () => throw new InvalidOperationException("There is no picture.")).Objects.Count != count)
            {
                throw new InvalidOperationException("Every object must have a label.");
            }
        }

        string name = "labelling" + count.ToString(CultureInfo.InvariantCulture);
        FigureLine.Write($"{name}.milliseconds", 1000 * Stopclock.BestSeconds(Label));
        long before = GC.GetAllocatedBytesForCurrentThread();
        Label();
        FigureLine.Write($"{name}.bytes_per_object", (GC.GetAllocatedBytesForCurrentThread() - before) / (double)count);
    }

    private static void Boxes(int count)
    {
        var random = new Random(1);
        Cuboid[] cuboids =
        [
            .. Enumerable
                .Range(0, count)
                .Select(_ => new Cuboid(InView(random), new Vector3D(1, 2.2, 0.8), Axes.FromHeading(360 * random.NextDouble()))),
        ];
        Camera camera = Camera();
        void Project()
        {
            foreach (Cuboid cuboid in cuboids)
            {
                CuboidProjector.BoxesOf(camera, cuboid);
            }
        }

        FigureLine.Write("box.nanoseconds", 1e9 * Stopclock.BestSeconds(Project) / count);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Project();
        FigureLine.Write("box.bytes", (GC.GetAllocatedBytesForCurrentThread() - before) / (double)count);
    }

    private static Vector3D InView(Random random)
    {
        double ahead = 10 + (90 * random.NextDouble());
        return new Vector3D((random.NextDouble() - 0.5) * ahead, ahead, 0);
    }

    private static Camera Camera() =>
        new(new Pose(Vector3D.Zero, Axes.Identity), new CameraIntrinsics(50, Size, Size.Aspect, 0.15, Lens.Ideal));
}
