using Harvester.Cli.Terminals;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The option --paint of harvest and drive.</summary>
public sealed class MeasuredPaintTests(SmallSession small) : IClassFixture<SmallSession>, IDisposable
{
    /// <summary>No width of the constants.</summary>
    private const double PaintedWidth = 4.4;

    private readonly TemporaryFolder _folder = new();

    private string Table => _folder.PathOf("paint.csv");

    private string Made => _folder.PathOf("made");

    private string[] Harvest => ["harvest", "--frames", "2", "--seed", "6", "--size", "80x60", "--no-report", "--out", Made];

    private string[] Drive => ["drive", "--seed", "6", "--distance", "15", "--out", Made];

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Harvest_labels_lanes_as_painted()
    {
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);

        CliRun.Of([.. Harvest, "--varied-roads", "--paint", Table]).AssertDone();

        LanesLabel[] known = [.. Lanes(Made).Where(lanes => lanes.Status == LaneStatus.Known)];
        Assert.NotEmpty(known);
        Assert.All(known, lanes => Assert.Equal(LaneWidthSource.Paint, lanes.LaneWidthSource));
        Assert.All(known, lanes => Assert.Equal(PaintedWidth, lanes.LaneWidthMetres!.Value, 3));
        LaneLineView[] markings = [.. known.SelectMany(lanes => lanes.Markings!)];
        Assert.NotEmpty(markings);
        Assert.All(markings, line => Assert.Equal(SolidPaint.SigmaMetres, line.SigmaMetres));
        string label = File.ReadAllText(Path.Combine(Made, "labels.jsonl"));
        Assert.Contains("\"source\":\"paint\",\"sigmaMetres\":0.02,", label, StringComparison.Ordinal);
        Assert.Contains("\"paint\": \"paint.csv\"", File.ReadAllText(Path.Combine(Made, "session.json")), StringComparison.Ordinal);
        CliRun.Of("validate", Made, "--schema").AssertDone();
        CliRun stats = CliRun.Of("stats", Made);
        Assert.Contains("lane geometry, of frames with known lanes: measured paint 100.0 %", stats.Out, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Paint_of_a_road_that_the_table_lacks_is_unknown()
    {
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);
        KeepLastLink();

        CliRun.Of([.. Harvest, "--paint", Table]).AssertDone();

        LanesLabel[] known = [.. Lanes(Made).Where(lanes => lanes.Status == LaneStatus.Known)];
        Assert.NotEmpty(known);
        Assert.All(known, lanes => Assert.Null(lanes.Markings));
        Assert.All(known, lanes => Assert.True(lanes.LaneWidthSource is LaneWidthSource.Constant or LaneWidthSource.NarrowConstant));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Relabelling_gives_the_lanes_of_a_harvest_with_paint()
    {
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);
        string relabelled = _folder.PathOf("relabelled");

        CliRun.Of([.. Harvest, "--paint", Table]).AssertDone();
        CliRun.Of("relabel", small.Folder, "--paint", Table, "--out", relabelled, "--no-report").AssertDone();

        Assert.Equal(Text(Made), Text(relabelled));

        static IEnumerable<string> Text(string folder) =>
            Lanes(folder)
                .Select(lanes =>
                    FormattableString.Invariant($"{lanes.Indicators} {lanes.LaneWidthMetres} {lanes.Markings!.Count} ")
                    + string.Join(' ', lanes.Markings.SelectMany(line => line.Points.Select(point => point.Pixel)))
                );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Drive_follows_the_painted_lanes()
    {
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);

        CliRun.Of([.. Drive, "--paint", Table, "--record", _folder.PathOf("recorded")]).AssertDone();

        LanesLabel[] known = [.. Lanes(_folder.PathOf("recorded")).Where(lanes => lanes.Status == LaneStatus.Known)];
        Assert.NotEmpty(known);
        Assert.All(known, lanes => Assert.Equal(LaneWidthSource.Paint, lanes.LaneWidthSource));
        Assert.Contains("\"paint\": \"paint.csv\"", File.ReadAllText(Path.Combine(Made, "drive.json")), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Paint_of_other_roads_is_refused(bool isHarvest)
    {
        SolidPaint.Write(SolidPaint.Moved(RecordedRoads()), Table, PaintedWidth);

        Refused(isHarvest, ExitCode.BadData, Table);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Damaged_table_is_refused(bool isHarvest)
    {
        File.WriteAllText(Table, "harvester paint,1\nlink,0,0,-200\n");

        Refused(isHarvest, ExitCode.BadData, $"{Table}: line 2");
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Missing_table_is_refused(bool isHarvest) => Refused(isHarvest, ExitCode.InputOutput, Table);

    [Fact]
    public void Paint_of_several_towns_is_refused()
    {
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);

        CliRun
            .Of("drive", "--seeds", "6-7", "--paint", Table, "--distance", "15", "--out", Made)
            .AssertFailed(ExitCode.Usage, "--paint belongs to one road network.");
    }

    private void Refused(bool isHarvest, int exitCode, string message)
    {
        CliRun run = CliRun.Of([.. isHarvest ? Harvest : Drive, "--paint", Table]);

        Assert.Equal(exitCode, run.ExitCode);
        Assert.Contains(message, run.Error, StringComparison.OrdinalIgnoreCase);
        Assert.Single(run.Error.TrimEnd('\n').Split('\n'));
        Assert.False(Directory.Exists(Made));
    }

    private RoadNetwork RecordedRoads() =>
        RoadCsvReader.Read(new StringReader(File.ReadAllText(Path.Combine(small.Folder, FramePaths.Roads))));

    private static IEnumerable<LanesLabel> Lanes(string folder) =>
        new SessionReader(folder).ReadLabels().Select(label => label.Lanes).OfType<LanesLabel>();

    private void KeepLastLink()
    {
        string[] lines = File.ReadAllLines(Table);
        string[] kept = lines[Array.FindLastIndex(lines, line => line.StartsWith("link,", StringComparison.Ordinal))..^1];
        File.WriteAllLines(Table, [lines[0], .. kept, $"end,1,{kept.Length - 1}"]);
    }
}
