using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Tests.Commands.Roads;

public sealed class RoadsPaintTests : IDisposable
{
    /// <summary>A straight road of one lane each way: edges at 5.4 - 0.25 m and a dashed line of 3 + 6 m in the middle.</summary>
    private const double EdgeOffset = 5.15;

    /// <summary>The required accuracy of a line in most places, metres.</summary>
    private const double Accuracy = 0.05;

    private readonly TemporaryFolder _folder = new();
    private readonly string _roads;

    public RoadsPaintTests()
    {
        _roads = _folder.File("roads.csv", WritingCommand.Roads);
        SharedHarvest.CopyTo(
            Session,
            "--frames",
            "8",
            "--hz",
            "2",
            "--seed",
            "5",
            "--size",
            "640x480",
            "--traffic",
            "0",
            "--no-report",
            "--roads",
            _roads
        );
    }

    private string Session => _folder.PathOf("session");

    private string Table => _folder.PathOf("paint.csv");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lines_of_a_straight_road_are_measured()
    {
        CliRun run = CliRun.Of("roads", "paint", Session, "--roads", _roads, "--out", Table);

        run.AssertDone();
        Assert.StartsWith($"{Table}: ", run.Out, StringComparison.Ordinal);
        RoadNetwork network = RoadImporter.Import(_roads).Network;
        LinePaint[] lines = [.. PaintFile.Read(Table, network).Links.SelectMany(link => link.Lines)];
        Assert.Contains(lines, line => Is(line, EdgeOffset, MarkingStyle.Solid, MarkingColour.White));
        Assert.Contains(lines, line => Is(line, 0, MarkingStyle.Dashed, MarkingColour.Yellow));
        Assert.All(
            lines.Where(line => line.Dashes is not null),
            line =>
            {
                Assert.InRange(line.Dashes!.Value.Period, 8.9, 9.1);
                Assert.InRange(line.Dashes!.Value.Length, 2.5, 3.5);
            }
        );
    }

    [Fact]
    public void Same_sessions_give_the_same_bytes()
    {
        CliRun.Of("roads", "paint", Session, "--roads", _roads, "--out", Table).AssertDone();
        byte[] first = File.ReadAllBytes(Table);

        CliRun.Of("roads", "paint", Session, "--roads", _roads, "--out", Table).AssertDone();

        Assert.Equal(first, File.ReadAllBytes(Table));
    }

    [Fact]
    public void Session_without_roads_needs_a_network() => Refused(Session, "has no recorded roads. Name a road network with --roads.");

    [Fact]
    [Trait("Category", "Heavy")]
    public void Another_network_is_refused()
    {
        using var small = new SmallSession();

        Refused(small.Folder, "was recorded on another road network", "--roads", _roads);
    }

    [Fact]
    public void Cameras_that_see_no_road_are_refused()
    {
        string far = _folder.File(
            "far.csv",
            WritingCommand
                .Roads.Replace(",0,0,", ",9,0,", StringComparison.Ordinal)
                .Replace(",30,,,,", ",300,,,,", StringComparison.Ordinal)
        );

        Refused(Session, "sees a road of the network", "--roads", far);
    }

    [Fact]
    public void Table_in_place_of_a_label_file_is_refused() =>
        CliRun
            .Of("roads", "paint", Session, "--roads", _roads, "--out", Path.Combine(Session, "labels.jsonl"))
            .AssertFailed(ExitCode.Usage, "would replace a file of");

    private void Refused(string session, string message, params string[] options)
    {
        CliRun.Of(["roads", "paint", session, "--out", Table, .. options]).AssertFailed(ExitCode.BadData, message);
        Assert.False(File.Exists(Table));
    }

    private static bool Is(LinePaint line, double offset, MarkingStyle style, MarkingColour colour) =>
        Math.Abs(line.FromOffset - offset) < Accuracy
        && Math.Abs(line.ToOffset - offset) < Accuracy
        && (line.Paint.Style, line.Paint.Colour) == (style, colour);
}
