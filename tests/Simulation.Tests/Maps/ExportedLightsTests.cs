using System.Text.Json;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Exports;
using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>Which light governs which lane in an export, compared with the lights that the town's traffic obeys.</summary>
[Trait("Category", "Heavy")]
public sealed class ExportedLightsTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>Labels have places to a millimetre or so, metres.</summary>
    private const double SameLight = 0.01;

    /// <summary>A lane's middle this near to a path of the traffic is that path's lane, metres: less than half of the narrowest.</summary>
    private const double SameLane = 1;

    /// <summary>Lanes of the map reach nearer to the junction than where traffic waits, metres.</summary>
    private const double MaxBeforeEnd = 15;

    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData(621)]
    [InlineData(622)]
    public void Topology_of_lights_is_that_of_the_traffic(int seed)
    {
        Site site = Site.OfTown(seed);
        (Vector3D Centre, RoadArm Arm)[] truth = [.. LightsOf(site)];
        SessionReader session = Harvest(seed, site.Network);
        FrameLabel[] labels = [.. session.ReadLabels()];
        string exported = Path.Combine(_folder, "out");
        new DatasetExporter(
            new ExportPlan(DatasetFormats.Find("openlane-v2")!, [session], new ExportOptions()),
            exported,
            Shard.Whole,
            SyncMode.Never
        ).Run(_ => { });

        string[] files =
        [
            .. Directory
                .EnumerateFiles(exported, "*-ls.json", SearchOption.AllDirectories)
                .OrderBy(file => int.Parse(Path.GetFileName(Path.GetDirectoryName(Path.GetDirectoryName(file)!)!)))
                .ThenBy(file => file, StringComparer.Ordinal),
        ];
        Assert.Equal(labels.Length, files.Length);
        (int elements, int joined) = (0, 0);
        foreach ((string file, FrameLabel label) in files.Zip(labels))
        {
            using JsonDocument document = JsonDocument.Parse(File.ReadAllText(file));
            JsonElement frame = document.RootElement;
            JsonElement annotation = frame.GetProperty("annotation");
            JsonElement[] lights = [.. annotation.GetProperty("traffic_element").EnumerateArray()];
            JsonElement[] lanes = [.. annotation.GetProperty("lane_segment").EnumerateArray()];
            JsonElement[] rows = [.. annotation.GetProperty("topology_lste").EnumerateArray()];
            Assert.Equal(lanes.Length, rows.Length);
            for (int column = 0; column < lights.Length; column++)
            {
                ObjectLabel light = label.Objects.Single(each => each.Id == lights[column].GetProperty("id").GetInt32());
                (Vector3D centre, RoadArm arm) = truth.MinBy(each => (each.Centre - light.Box3D.Centre).Length);
                Assert.Equal(0, (centre - light.Box3D.Centre).Length, SameLight);
                LanePath[] held =
                [
                    .. site.Lanes.Paths.Where(path => path.Road is { } road && road == arm.Road && path.IsForward != arm.AtStart),
                ];
                Assert.NotEmpty(held);
                for (int row = 0; row < lanes.Length; row++)
                {
                    Vector3D[] middle = [.. lanes[row].GetProperty("centerline").EnumerateArray().Select(point => ToWorld(frame, point))];
                    JsonElement[] onwards = [.. lanes.Where(next => Starts(next, lanes[row]))];

                    // A lane that the range cuts off does not show whether it reaches the light.
                    if (onwards.Length > 0)
                    {
                        bool isHeld = !IsWay(lanes[row]) && onwards.All(IsWay) && held.Any(path => EndsOn(middle, path));
                        Assert.Equal(isHeld ? 1 : 0, rows[row][column].GetInt32());
                        joined += isHeld ? 1 : 0;
                    }
                }

                elements++;
            }
        }

        output.WriteLine($"{elements} elements, {joined} lanes governed");
        Assert.True(joined > 0);
    }

    private static bool IsWay(JsonElement lane) => lane.GetProperty("is_intersection_or_connector").GetBoolean();

    /// <summary>Whether a lane begins where another one ends.</summary>
    private static bool Starts(JsonElement next, JsonElement lane)
    {
        JsonElement[] before = [.. lane.GetProperty("centerline").EnumerateArray()];
        JsonElement start = next.GetProperty("centerline")[0];
        return Enumerable.Range(0, 3).All(axis => Math.Abs(start[axis].GetDouble() - before[^1][axis].GetDouble()) < SameLight);
    }

    /// <summary>Whether a lane is that of a path of the traffic, and the last one before the path's end.</summary>
    private static bool EndsOn(Vector3D[] middle, LanePath path)
    {
        Vector3D end = path.Line.PositionAt(path.Length);
        Vector3D ahead = path.Line.TangentAt(path.Length);
        Vector3D apart = middle[^1] - end;
        double beyond = (apart.X * ahead.X) + (apart.Y * ahead.Y);
        double aside = Math.Abs((apart.X * ahead.Y) - (apart.Y * ahead.X));
        return beyond is > -SameLane and < MaxBeforeEnd && aside < SameLane && (middle[^1] - middle[^2]).Dot(ahead) > 0;
    }

    private static Vector3D ToWorld(JsonElement frame, JsonElement point)
    {
        JsonElement pose = frame.GetProperty("pose");
        double Axis(int row) =>
            Enumerable.Range(0, 3).Sum(i => pose.GetProperty("rotation")[row][i].GetDouble() * point[i].GetDouble())
            + pose.GetProperty("translation")[row].GetDouble();
        return new Vector3D(Axis(0), Axis(1), Axis(2));
    }

    private SessionReader Harvest(int seed, RoadNetwork network)
    {
        string folder = Path.Combine(_folder, "session");
        var game = new SimulatedGame(new SimulationOptions { Seed = seed });
        using var writer = new SessionWriter(
            folder,
            new SessionOrigin
            {
                Game = "simulation",
                Tool = "test",
                Seed = seed,
            }
        );
        using var text = new StringWriter();
        RoadCsvWriter.Write(network, text);
        writer.Keep(FramePaths.Roads, text.ToString());
        var options = new HarvestOptions
        {
            Image = new ImageSize(320, 240),
            MaxFrames = 20,
            RateHz = 0.5,
        };
        RoadNetwork roads = RoadCsvReader.Read(new StringReader(text.ToString()));
        using var session = new HarvestSession(options, game.Ports with { Roads = new FixedRoads(roads, "town") }, writer);
        do
        {
            writer.WaitForRoom();
            game.Tick(1.0 / 60);
            session.Step();
        } while (!session.Status.IsOver);
        session.Stop();
        writer.Dispose();
        Assert.Null(session.Fault ?? writer.Fault);
        return new SessionReader(folder);
    }

    private static IEnumerable<(Vector3D Centre, RoadArm Arm)> LightsOf(Site site)
    {
        var lights = new SignalProps(site.Signals, new HandleCounter());
        lights.AddAtStopLines(site.Index, ModelCatalogue.Shared);
        return lights.Lights.Select(light =>
            (light.Prop.State.Pose.ToWorld((light.Prop.State.ModelMin + light.Prop.State.ModelMax) * 0.5), light.Arm)
        );
    }
}
