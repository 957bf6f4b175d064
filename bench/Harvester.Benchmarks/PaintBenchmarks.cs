using BenchmarkDotNet.Attributes;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Benchmarks;

/// <summary>The search of paint in one image of 800x600 pixels: a straight road of two lanes each way, seen from a car.</summary>
[MemoryDiagnoser]
public class PaintBenchmarks
{
    private const double LinkLength = 10;
    private const int Links = 20;
    private const double HalfStripe = 0.075;
    private static readonly double[] s_lines = [-10.55, -5.4, 0, 5.4, 10.55];

    private PaintRoads _roads = null!;
    private PaintScanner _scanner = null!;
    private PaintImage _image = null!;
    private PaintEvidence _evidence = null!;

    [GlobalSetup]
    public void Setup()
    {
        RoadNode[] nodes =
        [
            .. Enumerable
                .Range(0, Links + 1)
                .Select(i => new RoadNode(RoadNode.NoArea, i, new Vector3D(0, i * LinkLength, 0), "", RoadNodeFlags.None)),
        ];
        RoadLink[] links = [.. Enumerable.Range(0, Links).Select(i => new RoadLink(i, i + 1, 2, 2, 0, RoadLinkFlags.None))];
        _roads = new PaintRoads(new RoadCurves(new RoadNetwork(nodes, links)));
        _scanner = new PaintScanner(_roads);
        var size = new ImageSize(800, 600);
        var camera = new Camera(
            new Pose(new Vector3D(2.7, 60, 1.4), Axes.FromHeading(0)),
            new CameraIntrinsics(50, size, size.Aspect, nearClip: 0.15, Lens.Ideal)
        );
        _image = new PaintImage(camera, Picture(camera), new RoadGround(), new byte[size.PixelCount]);
        _evidence = new PaintEvidence();
        Scan();
        _scanner.Scan(_image, 0, _evidence);
    }

    /// <summary>What is done for each image, except reading it.</summary>
    [Benchmark]
    public PaintEvidence Scan()
    {
        var evidence = new PaintEvidence();
        _scanner.Scan(_image, 0, evidence);
        return evidence;
    }

    /// <summary>What is done once for all images, here for the 30 m that one image shows.</summary>
    [Benchmark]
    public PaintTable Build() => PaintTableBuilder.Build(_roads, _evidence);

    private static byte[] Picture(Camera camera)
    {
        var random = new Random(1);
        byte[] rgb = new byte[3 * camera.Image.PixelCount];
        for (int i = 0; i < camera.Image.PixelCount; i++)
        {
            Ray ray = camera.RayThrough((i % camera.Image.Width) + 0.5, (i / camera.Image.Width) + 0.5);
            bool isPaint = ray.Direction.Z < 0 && IsPaint(ray.At(-ray.Origin.Z / ray.Direction.Z).X);
            byte value = (byte)((isPaint ? 200 : 80) + random.Next(-4, 5));
            (rgb[3 * i], rgb[(3 * i) + 1], rgb[(3 * i) + 2]) = (value, value, value);
        }

        return rgb;
    }

    private static bool IsPaint(double offset) => s_lines.Any(line => Math.Abs(offset - line) < HalfStripe);
}
