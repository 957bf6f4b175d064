using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Play.Surveys.Roads;

namespace Harvester.Play.Tests.Surveys.Roads;

public sealed class GrowingRoadsPaintTests : IDisposable
{
    private static readonly TimeSpan HangingAfter = TimeSpan.FromMinutes(1);

    private static readonly RoadNetwork Road = new(
        [.. Enumerable.Range(0, 2).Select(i => new RoadNode(0, i, new Vector3D(0, i * 100, 0), "", RoadNodeFlags.None))],
        [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None)]
    );

    private readonly string _folder = Directory.CreateTempSubdirectory("paint").FullName;

    private string Table => Path.Combine(_folder, "paint.csv");

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Lanes_and_paint_are_those_of_the_table()
    {
        File.WriteAllText(
            Table,
            "harvester paint,1\nlink,0,0,0,0,0,100,0,0,100\nline,0,0,100,0,0,dashed,yellow,0.15,,,,0.02,3\n"
                + "line,0,0,100,3.5,3.5,solid,white,0.15,,,,0.03,3\nend,1,2\n"
        );
        GrowingRoads roads = Prepared();

        LaneObservation seen = roads.Near(default)!.Lanes.Observe(new Vector3D(1.5, 40, 0), 0, 10, 4, [], null);

        Assert.Equal(LaneWidthSource.Paint, seen.WidthSource);
        Assert.Equal(2, seen.IndicatorsAtCar.ToMarkingMR.Value, 6);
        Assert.Equal([0.02, 0.03], ((IRoadPaint)roads).Near(default, 20).Select(line => line.SigmaMetres).Order());
    }

    [Theory]
    [InlineData("harvester paint,1\nlink,0,0,0,0,0\n", "line 2")]
    [InlineData("harvester paint,1\nlink,0,7,0,0,7,100,0,0,100\nend,1,0\n", "")]
    public void Table_that_is_damaged_or_of_other_roads_is_named(string table, string message)
    {
        File.WriteAllText(Table, table);
        GrowingRoads roads = Prepared();

        FormatException failure = Assert.IsType<FormatException>(roads.TakeFailure());

        Assert.StartsWith($"{Table}: {message}", failure.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', failure.Message);
        Assert.Null(roads.Near(default));
        Assert.Empty(((IRoadPaint)roads).Near(default, 20));
    }

    private GrowingRoads Prepared()
    {
        var roads = new GrowingRoads();
        roads.Prepare(() => Road, "roadFile", network => MeasuredPaintFile.Load(Table, network));
        Assert.True(SpinWait.SpinUntil(() => !roads.IsPreparing, HangingAfter));
        return roads;
    }
}
