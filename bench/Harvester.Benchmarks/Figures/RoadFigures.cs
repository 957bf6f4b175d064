using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Benchmarks.Figures;

/// <summary>
/// The network of the real game, where GTADATAHARVESTER_REALWORLD leads to it: read from the project's own file, and matched.
/// </summary>
internal static class RoadFigures
{
    private const int Places = 1000;

    public static void Run(string folder)
    {
        string? realWorld = Environment.GetEnvironmentVariable("GTADATAHARVESTER_REALWORLD");
        if (realWorld is null)
        {
            return;
        }

        string file = Path.Combine(folder, "roads.csv");
        RoadWriter.Write(RoadImporter.Import(Path.Combine(realWorld, "nodes.zip")).Network, file);
        RoadNetwork network = RoadImporter.Import(file).Network;
        FigureLine.Write("roads.links", network.Links.Count);
        FigureLine.Write("roads.load.seconds", Stopclock.BestSeconds(() => RoadImporter.Import(file)));
        var curves = new RoadCurves(network);
        var matcher = new RoadMatcher(curves, new LaneModel(network));
        var random = new Random(1);
        (Vector3D Position, double Heading)[] places = [.. Enumerable.Range(0, Places).Select(_ => Place(curves, random))];
        FigureLine.Write(
            "roads.match.microseconds",
            1e6
                / Places
                * Stopclock.BestSeconds(() =>
                {
                    foreach ((Vector3D position, double heading) in places)
                    {
                        matcher.Match(position, heading);
                    }
                })
        );
    }

    private static (Vector3D Position, double Heading) Place(RoadCurves curves, Random random)
    {
        RoadCurve curve = curves.Of(random.Next(curves.Network.Links.Count));
        double parameter = random.NextDouble();
        Vector2D direction = curve.DirectionAt(parameter);
        return (curve.PointBeside(parameter, 2.7), Angles.HeadingDegrees(new Vector3D(direction.X, direction.Y, 0)));
    }
}
