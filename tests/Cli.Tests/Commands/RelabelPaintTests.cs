using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;

namespace Harvester.Cli.Tests.Commands;

public sealed class RelabelPaintTests(SmallSession small) : IClassFixture<SmallSession>, IDisposable
{
    /// <summary>No width of the constants.</summary>
    private const double PaintedWidth = 4.4;

    private readonly TemporaryFolder _folder = new();

    private string Table => _folder.PathOf("paint.csv");

    private string Made => _folder.PathOf("made");

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Lanes_are_as_wide_as_painted()
    {
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);

        CliRun run = CliRun.Of("relabel", small.Folder, "--paint", Table, "--out", Made, "--no-report");

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        LanesLabel[] known = [.. new SessionReader(Made).ReadLabels().Select(label => label.Lanes).OfType<LanesLabel>().Where(IsKnown)];
        Assert.NotEmpty(known);
        Assert.All(known, lanes => Assert.Equal(LaneWidthSource.Paint, lanes.LaneWidthSource));
        Assert.All(known, lanes => Assert.Equal(PaintedWidth, lanes.LaneWidthMetres!.Value, 3));
        Assert.All(known, lanes => Assert.All(lanes.Markings!, line => Assert.Equal(MarkingStyle.Solid, line.Paint!.Value.Style)));
        Assert.Contains("\"paint\": \"paint.csv\"", File.ReadAllText(Path.Combine(Made, "session.json")), StringComparison.Ordinal);
    }

    [Fact]
    public void Paint_of_other_roads_is_refused()
    {
        SolidPaint.Write(SolidPaint.Moved(RecordedRoads()), Table, PaintedWidth);

        CliRun run = CliRun.Of("relabel", small.Folder, "--paint", Table, "--out", Made, "--no-report");

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(Table, run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.TrimEnd('\n').Split('\n'));
        Assert.False(Directory.Exists(Made));
    }

    [Fact]
    public void Session_without_roads_needs_a_network()
    {
        string roads = _folder.File("roads.csv", WritingCommand.Roads);
        string session = _folder.PathOf("session");
        SharedHarvest.CopyTo(session, "--frames", "1", "--seed", "6", "--size", "80x60", "--no-report", "--roads", roads);
        SolidPaint.Write(RecordedRoads(), Table, PaintedWidth);

        CliRun
            .Of("relabel", session, "--paint", Table, "--out", Made, "--no-report")
            .AssertFailed(ExitCode.BadData, "has no recorded roads. To use measured paint, name a road network with --roads.");
        Assert.False(Directory.Exists(Made));
    }

    private static bool IsKnown(LanesLabel lanes) => lanes.Status == LaneStatus.Known;

    private RoadNetwork RecordedRoads() =>
        RoadCsvReader.Read(new StringReader(File.ReadAllText(Path.Combine(small.Folder, FramePaths.Roads))));
}
