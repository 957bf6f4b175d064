using BenchmarkDotNet.Attributes;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Benchmarks;

/// <summary>Import and matching over the network of the real game, whose file the variable GTADATAHARVESTER_REALWORLD leads to.</summary>
[MemoryDiagnoser]
public class RoadBenchmarks
{
    private const int Places = 1000;

    private readonly (Vector3D Position, double Heading)[] _places = new (Vector3D, double)[Places];
    private RoadMatcher _matcher = null!;
    private RoadNetwork _network = null!;

    private static string File =>
        Path.Combine(
            Environment.GetEnvironmentVariable("GTADATAHARVESTER_REALWORLD")
                ?? throw new InvalidOperationException("Set GTADATAHARVESTER_REALWORLD to the folder with nodes.zip."),
            "nodes.zip"
        );

    [GlobalSetup]
    public void Setup()
    {
        _network = RoadImporter.Import(File).Network;
        var curves = new RoadCurves(_network);
        _matcher = new RoadMatcher(curves, new LaneModel(_network));
        var random = new Random(1);
        for (int i = 0; i < Places; i++)
        {
            RoadCurve curve = curves.Of(random.Next(_network.Links.Count));
            double parameter = random.NextDouble();
            Vector2D direction = curve.DirectionAt(parameter);
            _places[i] = (curve.PointBeside(parameter, 2.7), Angles.HeadingDegrees(new Vector3D(direction.X, direction.Y, 0)));
        }
    }

    [Benchmark]
    public RoadNetwork Import() => RoadImporter.Import(File).Network;

    [Benchmark]
    public RoadMatcher MakeMatcher() => new(new RoadCurves(_network), new LaneModel(_network));

    [Benchmark(OperationsPerInvoke = Places)]
    public int Match()
    {
        int matched = 0;
        foreach ((Vector3D position, double heading) in _places)
        {
            matched += _matcher.Match(position, heading).HasRoad ? 1 : 0;
        }

        return matched;
    }
}
