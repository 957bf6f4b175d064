using System.Globalization;
using System.Security.Cryptography;
using System.Text.Json;
using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Lane lines of exports with measured paint against the paint of roads whose widths and paint are drawn at random. The seeds and places
/// were not used to choose the method's constants.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class PaintedExportsTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>The required accuracy of exported lines up to 50 m, pixels of an image of 800x600.</summary>
    private const double MaxPixels = 2;

    /// <summary>
    /// Share of the points that have it so far: not all do, as is required. The rest are points beside the car, where a pixel is a few
    /// millimetres, of lines that were measured from another lane or in a bend.
    /// </summary>
    private const double MinShare = 0.9;

    private const string Frames = "100";

    /// <summary>Distance from the camera in which lines can be nearest to an exported point, metres.</summary>
    private const double Around = 130;

    private readonly TemporaryFolder _folder = new();
    private readonly SortedDictionary<string, List<double>> _errors = [];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Exported_lines_lie_on_the_paint_of_random_towns()
    {
        foreach (int seed in Seeds("211,212"))
        {
            Judge(new SimulationOptions { Seed = seed, HasVariedRoads = true }, "--places", "5");
        }

        Required();
    }

    [RealWorldFact("nodes.zip")]
    public void Exported_lines_lie_on_the_paint_of_the_games_roads()
    {
        string roads = _folder.PathOf("roads.csv");
        CliRun.Of("roads", "import", RealWorldFactAttribute.PathOf("nodes.zip")!, "--out", roads).AssertDone();
        RoadNetwork network = RoadImporter.Import(roads).Network;
        foreach (Vector2D near in new Vector2D[] { new(0, -1000), new(2000, 3000) })
        {
            var world = new SimulationOptions
            {
                Seed = 213,
                Roads = network,
                Near = near,
                HasVariedRoads = true,
            };
            Judge(world, "--roads", roads, FormattableString.Invariant($"--near={near.X},{near.Y}"));
        }

        Required();
    }

    private static IEnumerable<int> Seeds(string seeds) =>
        (Environment.GetEnvironmentVariable("GTADATAHARVESTER_PAINT_SEEDS") ?? seeds).Split(',').Select(int.Parse);

    private void Judge(SimulationOptions world, params string[] options)
    {
        string session = _folder.PathOf("session");
        string painted = _folder.PathOf("painted");
        string table = _folder.PathOf("paint.csv");
        string seed = FormattableString.Invariant($"{world.Seed}");
        string[] harvest = ["harvest", "--out", session, "--overwrite", "--varied-roads", "--seed", seed, "--frames", Frames, "--hz", "2"];
        CliRun.Of([.. harvest, "--no-report", .. options]).AssertDone();
        string[] roads = world.Roads is null ? [] : ["--roads", _folder.PathOf("roads.csv")];
        CliRun.Of(["roads", "paint", session, "--out", table, .. roads]).AssertDone();
        string[] relabel = ["relabel", session, "--paint", table, "--out", painted, "--overwrite", "--no-report"];
        CliRun.Of([.. relabel, .. roads]).AssertDone();

        var game = new SimulatedGame(world);
        FrameLabel[] labels = [.. new SessionReader(painted).ReadLabels()];
        ProjectedPaint[] paint =
        [
            .. labels.Select(label => new ProjectedPaint(game.Ports.Paint!.Near(label.Camera.Pose.Position, Around), label.Camera)),
        ];
        var byPicture = labels
            .Select((label, i) => (Hash: HashOf(Path.Combine(painted, label.Image)), Paint: paint[i]))
            .ToDictionary(frame => frame.Hash, frame => frame.Paint, StringComparer.Ordinal);
        foreach ((FrameLabel label, int i) in new SessionReader(session).ReadLabels().Select((label, i) => (label, i)))
        {
            Judge("constant width", paint[i], (label.Lanes?.Boundaries ?? []).SelectMany(line => line.Points).Select(point => point.Pixel));
        }

        Export("tusimple", painted, folder => TuSimple(folder, byPicture));
        Export("culane", painted, folder => CuLane(folder, byPicture));
        Export("openlane", painted, folder => OpenLane(folder, byPicture));
        foreach ((string format, List<double> errors) in _errors)
        {
            output.WriteLine(
                FormattableString.Invariant($"{format}: {errors.Count} points; {Quantile(errors, 0.5):0.00} px median, ")
                    + FormattableString.Invariant($"{Quantile(errors, 0.95):0.00} px 95 %, {100 * ShareWithin(errors):0.0} % within 2 px")
            );
        }
    }

    private void Export(string format, string session, Action<string> judge)
    {
        string folder = _folder.PathOf(format);
        CliRun.Of("export", session, "--format", format, "--out", folder).AssertDone();
        judge(folder);
        Directory.Delete(folder, recursive: true);
    }

    private void TuSimple(string folder, Dictionary<string, ProjectedPaint> paint)
    {
        foreach (string line in File.ReadLines(Directory.EnumerateFiles(folder, "label_data_*.json").Single()))
        {
            using JsonDocument frame = JsonDocument.Parse(line);
            double[] rows = Numbers(frame.RootElement.GetProperty("h_samples"));
            ProjectedPaint seen = paint[HashOf(Path.Combine(folder, frame.RootElement.GetProperty("raw_file").GetString()!))];
            foreach (JsonElement lane in frame.RootElement.GetProperty("lanes").EnumerateArray())
            {
                // Whole columns, of which the middle counts; -2 is no point.
                Judge(
                    "tusimple",
                    seen,
                    Numbers(lane)
                        .Zip(rows)
                        .Where(point => point.First >= 0)
                        .Select(point => new Vector2D(point.First + 0.5, point.Second + 0.5))
                );
            }
        }
    }

    private void CuLane(string folder, Dictionary<string, ProjectedPaint> paint)
    {
        foreach (string file in Directory.EnumerateFiles(folder, "*.lines.txt", SearchOption.AllDirectories))
        {
            foreach (string line in File.ReadLines(file))
            {
                double[][] points =
                [
                    .. line.Split(' ', StringSplitOptions.RemoveEmptyEntries)
                        .Select(text => double.Parse(text, CultureInfo.InvariantCulture))
                        .Chunk(2),
                ];
                Judge(
                    "culane",
                    paint[HashOf(file.Replace(".lines.txt", ".png", StringComparison.Ordinal))],
                    points.Select(point => new Vector2D(point[0] + 0.5, point[1] + 0.5))
                );
            }
        }
    }

    private void OpenLane(string folder, Dictionary<string, ProjectedPaint> paint)
    {
        foreach (string file in Directory.EnumerateFiles(folder, "*.json", SearchOption.AllDirectories).Where(IsFrame))
        {
            using JsonDocument frame = JsonDocument.Parse(File.ReadAllText(file));
            string image = Path.Combine(folder, "images", frame.RootElement.GetProperty("file_path").GetString()!);
            foreach (JsonElement line in frame.RootElement.GetProperty("lane_lines").EnumerateArray())
            {
                double[][] uv = [.. line.GetProperty("uv").EnumerateArray().Select(Numbers)];
                Judge("openlane", paint[HashOf(image)], uv[0].Zip(uv[1], (u, v) => new Vector2D(u, v)));
            }
        }

        static bool IsFrame(string file) => file.Contains("lane3d", StringComparison.Ordinal);
    }

    private void Judge(string format, ProjectedPaint paint, IEnumerable<Vector2D> points)
    {
        _errors.TryAdd(format, []);
        _errors[format].AddRange(points.Select(paint.Distance).OfType<double>());
    }

    private void Required()
    {
        foreach (string format in new[] { "tusimple", "culane", "openlane" })
        {
            Assert.NotEmpty(_errors[format]);
            Assert.InRange(ShareWithin(_errors[format]), MinShare, 1);
        }
    }

    /// <summary>Exports number the frames of each sequence from the start; the picture identifies the frame.</summary>
    private static string HashOf(string image) => Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(image)));

    private static double ShareWithin(List<double> errors) => (double)errors.Count(error => error <= MaxPixels) / errors.Count;

    private static double[] Numbers(JsonElement list) => [.. list.EnumerateArray().Select(number => number.GetDouble())];

    private static double Quantile(List<double> errors, double share) =>
        errors.Count == 0 ? double.NaN : errors.Order().ElementAt((int)(share * (errors.Count - 1)));
}
