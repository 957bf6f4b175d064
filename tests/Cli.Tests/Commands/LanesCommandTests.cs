using System.Globalization;
using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A straight road to the north with two lanes each way and no median: the line is at x = 0, the lanes are 5.4 m wide.</summary>
public sealed class LanesCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly string _roads;

    public LanesCommandTests()
    {
        _roads = _folder.PathOf("roads.csv");
        RoadNode[] nodes = [.. Enumerable.Range(0, 21).Select(i => new RoadNode(0, i, new Vector3D(0, 10 * i, 0), "", RoadNodeFlags.None))];
        RoadLink[] links = [.. Enumerable.Range(0, 20).Select(i => new RoadLink(i, i + 1, 2, 2, 0, RoadLinkFlags.None))];
        using StreamWriter writer = File.CreateText(_roads);
        RoadCsvWriter.Write(new RoadNetwork(nodes, links), writer);
    }

    [Fact]
    public void Lanes_gives_the_indicators_worked_out_by_hand()
    {
        // In the middle of the right lane, 8.1 m right of the line, turned 2 degrees to the right: ML = -2.7, MR = 2.7, LL = -8.1.
        JsonElement lanes = Lanes("--position", "8.1,50,0", "--heading", "358");

        Assert.Equal("known", lanes.GetProperty("status").GetString());
        Assert.Equal(1, lanes.GetProperty("lane").GetInt32());
        JsonElement indicators = lanes.GetProperty("indicators");
        Assert.Equal(0.034907, indicators.GetProperty("angle").GetDouble());
        Assert.Equal(-8.1, indicators.GetProperty("toMarkingLL").GetDouble());
        Assert.Equal(-2.7, indicators.GetProperty("toMarkingML").GetDouble());
        Assert.Equal(2.7, indicators.GetProperty("toMarkingMR").GetDouble());
        Assert.Equal(9.5, indicators.GetProperty("toMarkingRR").GetDouble());
        Assert.False(lanes.GetProperty("valid").GetProperty("toMarkingRR").GetBoolean());
        Assert.Equal(-2, lanes.GetProperty("torcsEquivalent").GetProperty("toMarkingML").GetDouble());
        Assert.Equal(70, indicators.GetProperty("distMM").GetDouble());
    }

    [Fact]
    public void Torcs_equivalent_has_the_angle_at_the_car()
    {
        // A circle to the left with a radius of 100 m. 10 m ahead along it, the road points 0.1 rad further to the left than at the car.
        string bend = _folder.PathOf("bend.csv");
        RoadNode[] nodes = [.. Enumerable.Range(0, 25).Select(i => new RoadNode(0, i, OnCircle(0.05 * i), "", RoadNodeFlags.None))];
        RoadLink[] links = [.. Enumerable.Range(0, 24).Select(i => new RoadLink(i, i + 1, 1, 1, 0, RoadLinkFlags.None))];
        using (StreamWriter writer = File.CreateText(bend))
        {
            RoadCsvWriter.Write(new RoadNetwork(nodes, links), writer);
        }

        CliRun run = CliRun.Of("lanes", "--roads", bend, "--position", "-17.84,61.62,0", "--heading", "36");
        JsonElement lanes = JsonDocument.Parse(run.Out).RootElement;

        double ahead = lanes.GetProperty("indicators").GetProperty("angle").GetDouble();
        double atCar = lanes.GetProperty("atCar").GetProperty("indicators").GetProperty("angle").GetDouble();
        Assert.Equal(atCar, lanes.GetProperty("torcsEquivalent").GetProperty("angle").GetDouble());
        Assert.Equal(0.1, ahead - atCar, 2);

        static Vector3D OnCircle(double angle) => new((100 * Math.Cos(angle)) - 100, 100 * Math.Sin(angle), 0);
    }

    [Fact]
    public void Lanes_measures_from_the_middle_of_the_box()
    {
        // Turned 30 degrees to the left, 2 m ahead are 2 sin 30 = 1 m to the west, and 1 m to the right is cos 30 = 0.866 m to the east.
        JsonElement lanes = Lanes("--position", "8.1,50,0", "--heading", "30", "--box-centre", "0,2,0.5");
        JsonElement right = Lanes("--position", "8.1,50,0", "--heading", "30", "--box-centre", "1,0,0.5");

        Assert.Equal(-1, lanes.GetProperty("offsetFromLaneCentreMetres").GetDouble());
        Assert.Equal(0.866, right.GetProperty("offsetFromLaneCentreMetres").GetDouble(), 3);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Lanes_at_the_box_centre_of_a_scene_equal_the_labels()
    {
        string session = _folder.PathOf("session");
        CliRun.Of("harvest", "--out", session, "--frames", "4", "--hz", "1", "--seed", "5", "--size", "64x48", "--no-report");
        FrameLabel[] known = [.. new SessionReader(session).ReadLabels().Where(label => label.Lanes!.Status == LaneStatus.Known)];

        Assert.NotEmpty(known);
        foreach (FrameLabel label in known)
        {
            string scene = Path.Combine(session, "scenes", $"{label.Frame:00000000}.json");
            JsonElement ego = JsonDocument.Parse(File.ReadAllText(scene)).RootElement.GetProperty("ego");
            var car = new Pose(Vector(ego, "position"), Axes.FromVectors(Vector(ego, "right"), Vector(ego, "forward"), Vector(ego, "up")));
            Vector3D middle = car.ToWorld((Vector(ego, "modelMin") + Vector(ego, "modelMax")) * 0.5);
            CliRun run = CliRun.Of(
                "lanes",
                "--roads",
                Path.Combine(session, "scenes", "roads.csv"),
                "--position",
                Text(middle.X, middle.Y, middle.Z),
                "--heading",
                Text(Angles.HeadingDegrees(car.Axes.Forward))
            );
            JsonElement lanes = JsonDocument.Parse(run.Out).RootElement;

            Assert.Equal(label.Lanes!.Indicators!.Angle.Value, lanes.GetProperty("indicators").GetProperty("angle").GetDouble());
            Assert.Equal(label.Lanes.Indicators.ToMarkingML.Value, lanes.GetProperty("indicators").GetProperty("toMarkingML").GetDouble());
            Assert.Equal(label.Lanes.OffsetFromLaneCentreMetres!.Value, lanes.GetProperty("offsetFromLaneCentreMetres").GetDouble());
        }

        static Vector3D Vector(JsonElement ego, string name) =>
            new(ego.GetProperty(name)[0].GetDouble(), ego.GetProperty(name)[1].GetDouble(), ego.GetProperty(name)[2].GetDouble());

        static string Text(params double[] numbers) =>
            string.Join(",", numbers.Select(number => number.ToString(CultureInfo.InvariantCulture)));
    }

    [Fact]
    public void Lanes_of_narrow_roads_have_a_separate_width()
    {
        string narrow = _folder.PathOf("narrow.csv");
        File.WriteAllText(narrow, File.ReadAllText(_roads).Replace(",2,2,0,,", ",2,2,0,narrowRoad,", StringComparison.Ordinal));

        Assert.Equal((4, "narrowConstant"), Width("--roads", narrow, "--lane-width", "5"));
        Assert.Equal((3.5, "narrowConstant"), Width("--roads", narrow, "--narrow-lane-width", "3.5"));
        Assert.Equal((5, "constant"), Width("--roads", _roads, "--lane-width", "5", "--narrow-lane-width", "3.5"));

        static (double, string?) Width(params string[] options)
        {
            CliRun run = CliRun.Of(["lanes", "--position", "1,50,0", "--heading", "0", .. options]);
            Assert.Equal("", run.Error);
            JsonElement lanes = JsonDocument.Parse(run.Out).RootElement;
            return (lanes.GetProperty("laneWidthMetres").GetDouble(), lanes.GetProperty("laneWidthSource").GetString());
        }
    }

    [Fact]
    public void Lanes_reads_vehicles_from_a_file()
    {
        string vehicles = _folder.PathOf("vehicles.csv");
        File.WriteAllText(vehicles, "2.7,80,0,0\n8.1,75,0,0,6\n-2.7,70,0,180\n");

        JsonElement lanes = Lanes("--position", "8.1,50,0", "--heading", "0", "--vehicles", vehicles, "--length", "4");

        // 25 m ahead, centre to centre; 25 - (4 + 6) / 2 = 20 m bumper to bumper.
        Assert.Equal(25, lanes.GetProperty("indicators").GetProperty("distMM").GetDouble());
        Assert.Equal(30, lanes.GetProperty("indicators").GetProperty("distLL").GetDouble());
        JsonElement nearest = lanes.GetProperty("vehicles").EnumerateArray().Single(vehicle => vehicle.GetProperty("id").GetInt32() == 2);
        Assert.Equal(20, nearest.GetProperty("bumperDistanceMetres").GetDouble());
        Assert.True(lanes.GetProperty("vehicles")[0].GetProperty("oncoming").GetBoolean());
    }

    [Fact]
    public void Lanes_looks_ahead_by_metres_or_by_speed()
    {
        Assert.Equal(25, LookAhead("25"));
        Assert.Equal(12, LookAhead("1s", "--speed", "12"));
        Assert.Equal(0, LookAhead("0"));

        double LookAhead(string ahead, params string[] more) =>
            Lanes(["--position", "8.1,50,0", "--heading", "0", "--look-ahead", ahead, .. more]).GetProperty("lookAheadMetres").GetDouble();
    }

    [Theory]
    [InlineData("-1")]
    [InlineData("71")]
    [InlineData("6s")]
    [InlineData("s")]
    public void Lanes_with_an_impossible_look_ahead_is_a_usage_error(string ahead) =>
        CliRun
            .Of("lanes", "--roads", _roads, "--position", "8.1,50,0", "--heading", "0", "--look-ahead", ahead)
            .AssertFailed(2, "--look-ahead takes");

    [Fact]
    public void Lanes_reports_an_off_road_position() =>
        Assert.Equal("offRoad", Lanes("--position", "80,50,0", "--heading", "0").GetProperty("status").GetString());

    [Fact]
    public void Lanes_with_a_bad_vehicle_names_the_line()
    {
        string vehicles = _folder.PathOf("vehicles.csv");
        File.WriteAllText(vehicles, "2.7,80,0,0\nnear\n");

        CliRun
            .Of("lanes", "--roads", _roads, "--position", "8.1,50,0", "--heading", "0", "--vehicles", vehicles)
            .AssertFailed(1, "vehicles.csv, line 2");
    }

    [Fact]
    public void Lanes_without_roads_is_a_usage_error() =>
        CliRun.Of("lanes", "--position", "8.1,50,0", "--heading", "0").AssertFailed(2, "--roads");

    public void Dispose() => _folder.Dispose();

    private JsonElement Lanes(params string[] options)
    {
        CliRun run = CliRun.Of(["lanes", "--roads", _roads, .. options]);
        Assert.Equal(0, run.ExitCode);
        return JsonDocument.Parse(run.Out).RootElement;
    }
}
