using System.Text.Json;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.OpenLaneV2;

/// <summary>OpenLane-V2, read as its description has it, against the labels and within itself.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class OpenLaneV2WriterTests(SimulatedSession simulated) : ExportTests
{
    /// <summary>Coordinates have four decimals, and labels three, metres.</summary>
    private const double Rounding = 0.002;

    /// <summary>Lanes in a bend are polylines that leave their curve by up to half a centimetre, in both descriptions.</summary>
    private const double MaxDeviation = 0.02;

    [Fact]
    public void Edges_of_lanes_are_the_boundaries_of_the_label()
    {
        int points = 0;
        foreach ((FrameLabel label, JsonElement frame) in Frames("-ls"))
        {
            Vector3D[][] edges =
            [
                .. Lanes(frame)
                    .SelectMany(lane => new[] { lane.GetProperty("left_laneline"), lane.GetProperty("right_laneline") })
                    .Select(Points),
            ];
            foreach (
                Vector3D place in label.Lanes!.Boundaries.SelectMany(line => line.Points).Select(point => ToVehicle(frame, point.World))
            )
            {
                if (Math.Abs(place.X) < 50 && Math.Abs(place.Y) < 25)
                {
                    Assert.InRange(edges.Min(edge => Distance(edge, place)), 0, MaxDeviation);
                    points++;
                }
            }
        }

        Assert.True(points > 50);
    }

    [Fact]
    public void Topology_joins_exactly_the_lanes_that_meet()
    {
        int joined = 0;
        foreach ((_, JsonElement frame) in Frames("-ls"))
        {
            Vector3D[][] centres = [.. Lanes(frame).Select(lane => Points(lane.GetProperty("centerline")))];
            JsonElement[] rows = [.. frame.GetProperty("annotation").GetProperty("topology_lsls").EnumerateArray()];
            Assert.Equal(centres.Length, rows.Length);
            for (int i = 0; i < centres.Length; i++)
            {
                int[] row = [.. rows[i].EnumerateArray().Select(value => value.GetInt32())];
                for (int j = 0; j < centres.Length; j++)
                {
                    Vector3D[] next = centres[j];
                    bool meets =
                        i != j
                        && (next[0] - centres[i][^1]).Length < Rounding
                        && (next[1] - next[0]).Dot(centres[i][^1] - centres[i][^2]) > 0;
                    Assert.Equal(meets ? 1 : 0, row[j]);
                    joined += row[j];
                }
            }
        }

        Assert.True(joined > 20);
    }

    [Fact]
    public void Ego_is_on_the_lane_that_the_label_names()
    {
        foreach ((FrameLabel label, JsonElement frame) in Frames(""))
        {
            JsonElement lane = frame
                .GetProperty("annotation")
                .GetProperty("lane_centerline")
                .EnumerateArray()
                .Single(lane => lane.GetProperty("name").GetString() == label.Lanes!.LaneId);
            const double halfLane = 2.7;
            Assert.InRange(Distance(Points(lane.GetProperty("points")), default), 0, halfLane);
        }
    }

    [Fact]
    public void Points_project_onto_their_pixels()
    {
        foreach ((FrameLabel label, JsonElement frame) in Frames(""))
        {
            JsonElement camera = frame.GetProperty("sensor").GetProperty("ring_front_center");
            double[][] rotation = Rows(camera.GetProperty("extrinsic").GetProperty("rotation"));
            Vector3D origin = Point(camera.GetProperty("extrinsic").GetProperty("translation"));
            double[][] k = Rows(camera.GetProperty("intrinsic").GetProperty("K"));
            foreach (var point in label.Lanes!.Boundaries.SelectMany(line => line.Points))
            {
                // Columns of the rotation are the camera's axes: right, down, forward.
                Vector3D from = ToVehicle(frame, point.World) - origin;
                double Along(int axis) => (rotation[0][axis] * from.X) + (rotation[1][axis] * from.Y) + (rotation[2][axis] * from.Z);
                double pixels = 0.01 + (k[0][0] * Rounding / Along(2));
                Assert.Equal(point.Pixel.X, (k[0][0] * Along(0) / Along(2)) + k[0][2], pixels);
                Assert.Equal(point.Pixel.Y, (k[1][1] * Along(1) / Along(2)) + k[1][2], pixels);
            }
        }
    }

    [Fact]
    public void Lanes_have_the_same_ids_in_all_frames()
    {
        (string? Name, long Id)[] ids =
        [
            .. Frames("-ls")
                .SelectMany(pair => Lanes(pair.Frame))
                .Select(lane => (lane.GetProperty("name").GetString(), lane.GetProperty("id").GetInt64()))
                .Distinct(),
        ];

        Assert.Equal(ids.Length, ids.Select(lane => lane.Id).Distinct().Count());
        Assert.Equal(ids.Length, ids.Select(lane => lane.Name).Distinct().Count());
    }

    private IEnumerable<(FrameLabel Label, JsonElement Frame)> Frames(string suffix)
    {
        Folder.Export("openlane-v2", simulated.OpenWithRoads());
        using JsonDocument index = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/data_dict_gta.json")));
        string[] names =
        [
            .. index
                .RootElement.GetProperty("train")
                .EnumerateObject()
                .SelectMany(segment =>
                    segment.Value.EnumerateArray().Select(name => $"out/train/{segment.Name}/info/{name.GetString()![..^5]}{suffix}.json")
                ),
        ];
        Assert.Equal(SimulatedSession.Frames, names.Length);
        foreach ((string name, FrameLabel label) in names.Zip(simulated.OpenWithRoads().ReadLabels()))
        {
            using JsonDocument frame = JsonDocument.Parse(File.ReadAllText(Folder.PathOf(name)));
            Assert.True(
                File.Exists(
                    Folder.PathOf(
                        "out/"
                            + frame.RootElement.GetProperty("sensor").GetProperty("ring_front_center").GetProperty("image_path").GetString()
                    )
                )
            );
            yield return (label, frame.RootElement);
        }
    }

    private static JsonElement.ArrayEnumerator Lanes(JsonElement frame) =>
        frame.GetProperty("annotation").GetProperty("lane_segment").EnumerateArray();

    /// <summary>A place of the world in the frame of "pose", whose columns are its axes.</summary>
    private static Vector3D ToVehicle(JsonElement frame, Vector3D world)
    {
        double[][] m = Rows(frame.GetProperty("pose").GetProperty("rotation"));
        Vector3D from = world - Point(frame.GetProperty("pose").GetProperty("translation"));
        double Along(int axis) => (m[0][axis] * from.X) + (m[1][axis] * from.Y) + (m[2][axis] * from.Z);
        return new Vector3D(Along(0), Along(1), Along(2));
    }

    /// <summary>Distance of a place from a line on the ground.</summary>
    private static double Distance(Vector3D[] line, Vector3D place)
    {
        double least = double.PositiveInfinity;
        for (int i = 1; i < line.Length; i++)
        {
            var along = new Vector2D(line[i].X - line[i - 1].X, line[i].Y - line[i - 1].Y);
            var to = new Vector2D(place.X - line[i - 1].X, place.Y - line[i - 1].Y);
            double t = Math.Clamp(to.Dot(along) / Math.Max(along.Dot(along), double.Epsilon), 0, 1);
            least = Math.Min(least, (to - (along * t)).Length);
        }

        return least;
    }

    private static Vector3D[] Points(JsonElement list) => [.. list.EnumerateArray().Select(Point)];

    private static Vector3D Point(JsonElement point) => new(point[0].GetDouble(), point[1].GetDouble(), point[2].GetDouble());

    private static double[][] Rows(JsonElement rows) =>
        [.. rows.EnumerateArray().Select(row => row.EnumerateArray().Select(value => value.GetDouble()).ToArray())];
}
