using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The option --paint of plan run.</summary>
public sealed class PlanPaintTests : IDisposable
{
    private const string Plan = """
        {"name":"small","places":[{"name":"a","x":0,"y":-50}],"frames":2,"hz":2,"cameras":[{"name":"c","width":64,"height":48}],
        "traffic":0,"pedestrians":0,"parked":0}
        """;

    /// <summary>No width of the constants.</summary>
    private const double PaintedWidth = 4.4;

    private readonly TemporaryFolder _folder = new();
    private readonly RoadNetwork _network = RoadCsvReader.Read(new StringReader(WritingCommand.Roads));
    private readonly string[] _command;

    public PlanPaintTests() =>
        _command = [
            "plan",
            "run",
            _folder.File("plan.json", Plan),
            "--roads",
            _folder.File("roads.csv", WritingCommand.Roads),
            "--out",
            _folder.PathOf("out"),
            "--resume",
        ];

    private string World => File.ReadAllText(_folder.PathOf(Path.Combine("out", "world.json")));

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Trials_have_the_lanes_of_the_table_that_resume_needs()
    {
        CliRun.Of([.. _command, "--paint", Table("paint.csv", PaintedWidth)]).AssertDone();

        string session = Assert.Single(Directory.GetDirectories(_folder.PathOf(Path.Combine("out", "trials"))));
        LanesLabel[] lanes = [.. new SessionReader(session).ReadLabels().Select(label => label.Lanes).OfType<LanesLabel>()];
        Assert.Equal(2, lanes.Length);
        Assert.All(lanes, label => Assert.Equal(LaneWidthSource.Paint, label.LaneWidthSource));
        Assert.All(lanes, label => Assert.Equal(PaintedWidth, label.LaneWidthMetres!.Value, 3));
        Assert.Contains("\"paint\": \"paint.csv\"", File.ReadAllText(Path.Combine(session, "session.json")), StringComparison.Ordinal);
        Assert.Contains(",\"paint\":\"", World, StringComparison.Ordinal);

        CliRun.Of([.. _command, "--paint", Table("copy.csv", PaintedWidth)]).AssertDone();
        Refused(ExitCode.Usage, "has results of other roads, other paint or another detail", Table("other.csv", PaintedWidth + 0.1));
        CliRun without = CliRun.Of(_command);
        without.AssertFailed(ExitCode.Usage, "has results of other roads, other paint or another detail");
    }

    [Fact]
    public void World_without_paint_is_that_of_earlier_versions()
    {
        CliRun.Of(_command).AssertDone();

        Assert.Matches("^\\{\"roads\":\"[0-9a-f]{64}\",\"detail\":\"plain\"\\}\n$", World);
    }

    [Fact]
    public void Unusable_table_is_refused()
    {
        Refused(ExitCode.BadData, "damaged.csv: line 2", _folder.File("damaged.csv", "harvester paint,1\nlink,0,0\n"));
        Refused(ExitCode.InputOutput, "missing.csv", _folder.PathOf("missing.csv"));
        SolidPaint.Write(SolidPaint.Moved(_network), _folder.PathOf("moved.csv"), PaintedWidth);
        Refused(ExitCode.BadData, "measured on another road network", _folder.PathOf("moved.csv"));
        Assert.False(Directory.Exists(_folder.PathOf("out")));
    }

    private string Table(string name, double laneWidth)
    {
        SolidPaint.Write(_network, _folder.PathOf(name), laneWidth);
        return _folder.PathOf(name);
    }

    private void Refused(int exitCode, string message, string table)
    {
        CliRun run = CliRun.Of([.. _command, "--paint", table]);

        run.AssertFailed(exitCode, message);
        Assert.Single(run.Error.TrimEnd('\n').Split('\n'));
    }
}
