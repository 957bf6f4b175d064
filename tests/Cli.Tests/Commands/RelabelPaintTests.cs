using Harvester.Cli.Terminals;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
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
        Write(RecordedRoads());

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
        RoadNetwork roads = RecordedRoads();
        Write(
            new RoadNetwork(
                [.. roads.Nodes.Select(node => node with { Position = node.Position + new Geometry.Vector3D(7, 0, 0) })],
                roads.Links
            )
        );

        CliRun run = CliRun.Of("relabel", small.Folder, "--paint", Table, "--out", Made, "--no-report");

        Assert.Equal(ExitCode.BadData, run.ExitCode);
        Assert.Contains(Table, run.Error, StringComparison.Ordinal);
        Assert.Single(run.Error.TrimEnd('\n').Split('\n'));
        Assert.False(Directory.Exists(Made));
    }

    private static bool IsKnown(LanesLabel lanes) => lanes.Status == LaneStatus.Known;

    private RoadNetwork RecordedRoads() =>
        RoadCsvReader.Read(new StringReader(File.ReadAllText(Path.Combine(small.Folder, FramePaths.Roads))));

    /// <summary>A table in which every boundary of lanes is painted as a solid line: yellow at left edges, white elsewhere.</summary>
    private void Write(RoadNetwork roads)
    {
        var curves = new RoadCurves(roads);
        using var text = new StreamWriter(Table);
        PaintCsvWriter.Write(new PaintTable(roads, Enumerable.Range(0, roads.Links.Count).Select(link => Painted(curves, link))), text);
    }

    private static LinkPaint Painted(RoadCurves curves, int link)
    {
        RoadLink road = curves.Network.Links[link];
        double length = curves.Of(link).Length;
        double left = road.IsOneWay ? -road.LanesForward * PaintedWidth / 2 : (road.MedianWidth ?? 0) / 2;
        LinePaint Line(double offset, MarkingColour colour) =>
            new(0, length, offset, offset, new MarkingPaint(MarkingStyle.Solid, colour, 0.15)) { SigmaMetres = 0.02, Images = 3 };
        List<LinePaint> lines = [];
        if (road.LanesForward > 0)
        {
            lines.Add(Line(left, MarkingColour.Yellow));
            lines.Add(Line(left + (road.LanesForward * PaintedWidth), MarkingColour.White));
        }

        if (road.LanesBackward > 0)
        {
            double edge = road.LanesForward > 0 ? left : -road.LanesBackward * PaintedWidth / 2;
            lines.Add(Line(-edge - (road.LanesBackward * PaintedWidth), MarkingColour.White));
            if (edge != 0 || road.LanesForward == 0)
            {
                lines.Add(Line(-edge, MarkingColour.Yellow));
            }
        }

        return new LinkPaint(link, 0, length, lines);
    }
}
