using System.Security.Cryptography;
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

    /// <summary>Share of the points, in frames with measured lines, that have it: accuracies are required at 95 %.</summary>
    private const double MinShare = 0.95;

    /// <summary>Nearer, 2 px are less than 1.6 cm, metres: half of the required accuracy of lines.</summary>
    private const double Near = 5;

    /// <summary>Exports of frames in which no line was measured have the boundaries of the constant width.</summary>
    private const string Unmeasured = ", no line measured";

    private const string Frames = "100";

    /// <summary>Distance from the camera in which lines can be nearest to an exported point, metres.</summary>
    private const double Around = 130;

    private readonly TemporaryFolder _folder = new();
    private readonly SortedDictionary<string, List<(double Pixels, double Depth)>> _errors = [];

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Exported_lines_lie_on_the_paint_of_random_towns()
    {
        foreach (int seed in TestSeeds.Or([245], [245, 246]))
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
        Vector2D[] places = [new(0, -1000), new(2000, 3000)];
        foreach (Vector2D near in ProofSize.Of(places[..1], places))
        {
            var world = new SimulationOptions
            {
                Seed = 247,
                Roads = network,
                Near = near,
                HasVariedRoads = true,
            };
            Judge(world, "--roads", roads, FormattableString.Invariant($"--near={near.X},{near.Y}"));
        }

        Required();
    }

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
            .Select((label, i) => (Hash: HashOf(Path.Combine(painted, label.Image)), i))
            .ToDictionary(frame => frame.Hash, frame => frame.i, StringComparer.Ordinal);
        foreach ((FrameLabel label, int i) in new SessionReader(session).ReadLabels().Select((label, i) => (label, i)))
        {
            Judge("constant width", paint[i], (label.Lanes?.Boundaries ?? []).SelectMany(line => line.Points).Select(point => point.Pixel));
        }

        foreach ((string format, Func<string, IEnumerable<(string Image, Vector2D[] Points)>> lines) in ExportedLines.Readers)
        {
            string folder = _folder.PathOf(format);
            CliRun.Of("export", painted, "--format", format, "--out", folder).AssertDone();
            foreach ((string image, Vector2D[] points) in lines(folder))
            {
                int frame = byPicture[HashOf(image)];
                Judge(labels[frame].Lanes?.Markings is null ? format + Unmeasured : format, paint[frame], points);
            }

            Directory.Delete(folder, recursive: true);
        }

        foreach ((string format, List<(double Pixels, double Depth)> errors) in _errors)
        {
            output.WriteLine(
                FormattableString.Invariant($"{format}: {errors.Count} points; {Quantile(errors, 0.5):0.00} px median, ")
                    + FormattableString.Invariant(
                        $"{Quantile(errors, 0.95):0.00} px 95 %, {100 * ShareWithin(errors, 0):0.0} % within 2 px, "
                    )
                    + FormattableString.Invariant($"{100 * ShareWithin(errors, Near):0.0} % of those from 5 m on")
            );
        }
    }

    private void Judge(string format, ProjectedPaint paint, IEnumerable<Vector2D> points)
    {
        _errors.TryAdd(format, []);
        _errors[format].AddRange(points.Select(paint.Nearest).OfType<(double, double)>());
    }

    private void Required()
    {
        foreach (string format in ExportedLines.Readers.Keys)
        {
            Assert.NotEmpty(_errors[format]);
            Assert.InRange(ShareWithin(_errors[format], fromDepth: 0), MinShare, 1);
        }
    }

    /// <summary>Exports number the frames of each sequence from the start; the picture identifies the frame.</summary>
    private static string HashOf(string image) => Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(image)));

    private static double ShareWithin(List<(double Pixels, double Depth)> errors, double fromDepth)
    {
        List<(double Pixels, double Depth)> judged = errors.FindAll(error => error.Depth >= fromDepth);
        return (double)judged.Count(error => error.Pixels <= MaxPixels) / judged.Count;
    }

    private static double Quantile(List<(double Pixels, double Depth)> errors, double share) =>
        errors.Count == 0 ? double.NaN : errors.Select(error => error.Pixels).Order().ElementAt((int)(share * (errors.Count - 1)));
}
