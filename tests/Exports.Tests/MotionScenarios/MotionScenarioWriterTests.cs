using System.Text.Json;
using Harvester.Exports.Formats.MotionScenarios;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.MotionScenarios;

/// <summary>Scenarios of GPUDrive and WOMD against the labels of their session, and against each other.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class MotionScenarioWriterTests(SimulatedSession simulated) : ExportTests
{
    /// <summary>Labels have three decimals, metres.</summary>
    private const double Rounding = 0.002;

    /// <summary>The same of an angle over half of a person's depth, radians.</summary>
    private const double Turn = 1e-3;

    /// <summary>WOMD has sizes and headings as float.</summary>
    private const double Single = 1e-5;

    /// <summary>Frames of a session of two frames a second are five steps apart.</summary>
    private const int StepsPerFrame = 5;

    [Fact]
    public void States_at_frames_are_the_boxes_of_labels()
    {
        JsonElement root = GpuDrive();
        Dictionary<int, JsonElement> objects = root.GetProperty("objects")
            .EnumerateArray()
            .ToDictionary(item => item.GetProperty("id").GetInt32());
        int compared = 0;
        foreach ((int frame, FrameLabel label) in simulated.OpenWithRoads().ReadLabels().Index())
        {
            int step = frame * StepsPerFrame;
            foreach (
                ObjectLabel item in label.Objects.Where(item =>
                    item.Class is ObjectClass.Car or ObjectClass.Truck or ObjectClass.Pedestrian
                )
            )
            {
                JsonElement track = objects[item.Id];
                Assert.True(track.GetProperty("valid")[step].GetBoolean());
                Assert.Equal(item.Class == ObjectClass.Pedestrian ? "pedestrian" : "vehicle", track.GetProperty("type").GetString());
                Assert.InRange((Point(track.GetProperty("position")[step]) - item.Box3D.Centre).Length, 0, Rounding);
                Vector3D forward = item.Box3D.Axes.Forward;
                double heading = track.GetProperty("heading")[step].GetDouble();
                Assert.InRange(Math.Abs(Math.IEEERemainder(heading - Math.Atan2(forward.Y, forward.X), 2 * Math.PI)), 0, Turn);
                Assert.Equal(item.Velocity.X, track.GetProperty("velocity")[step].GetProperty("x").GetDouble(), Rounding);
                compared++;
            }
        }

        Assert.True(compared > 10);
    }

    [Fact]
    public void Steps_between_frames_are_interpolated_and_named()
    {
        JsonElement root = GpuDrive();
        JsonElement metadata = root.GetProperty("metadata");
        Assert.Equal(
            Enumerable.Range(0, SimulatedSession.Frames).Select(frame => frame * StepsPerFrame),
            metadata.GetProperty("measured_steps").EnumerateArray().Select(step => step.GetInt32())
        );
        JsonElement ego = root.GetProperty("objects")[metadata.GetProperty("sdc_track_index").GetInt32()];
        JsonElement position = ego.GetProperty("position");
        Assert.Equal(((SimulatedSession.Frames - 1) * StepsPerFrame) + 1, position.GetArrayLength());
        Vector3D expected = (Point(position[0]) * 0.6) + (Point(position[StepsPerFrame]) * 0.4);
        Assert.InRange((Point(position[2]) - expected).Length, 0, Rounding);
        Assert.True((Point(position[0]) - Point(position[position.GetArrayLength() - 1])).Length > 1);
    }

    [Fact]
    public void Womd_has_what_gpudrive_has_and_which_lane_leads_to_which()
    {
        GpuDrive();
        Folder.Export("womd", simulated.OpenWithRoads(), to: "womd");
        LogReading json = GpuDriveReader.Read(Folder.PathOf("out/train/0000_0000.json"));
        LogReading proto = Assert.Single(WomdReader.Read(Folder.PathOf("womd/train.tfrecord-00000-of-00001")));

        Assert.Empty(json.LeftOut);
        Assert.Empty(proto.LeftOut);
        Assert.Equal(json.Log.Times, proto.Log.Times);
        Assert.Equal(json.Log.Ego, proto.Log.Ego);
        foreach ((var one, var other) in json.Log.Tracks.Zip(proto.Log.Tracks))
        {
            Assert.Equal((one.Id, one.Kind), (other.Id, other.Kind));
            foreach ((var state, var same) in one.States.Zip(other.States))
            {
                Assert.Equal(state is null, same is null);
                Assert.InRange((state?.Centre - same?.Centre ?? Vector3D.Zero).Length, 0, Single);
                Assert.InRange(Math.Abs((state?.Heading ?? 0) - (same?.Heading ?? 0)), 0, Single);
            }
        }

        Assert.Equal(json.Log.Signals.Select(step => step.Count), proto.Log.Signals.Select(step => step.Count));
        Assert.Equal(
            json.Log.Features.Select(part => (part.Id, part.Kind, part.Type)),
            proto.Log.Features.Select(part => (part.Id, part.Kind, part.Type))
        );
        var parts = proto.Log.Features.ToDictionary(part => part.Id);
        int joined = 0;
        foreach (var lane in proto.Log.Features)
        {
            foreach (long exit in lane.Exits)
            {
                Assert.Contains(lane.Id, parts[exit].Entries);
                Assert.InRange((parts[exit].Points[0] - lane.Points[^1]).Length, 0, Rounding);
                joined++;
            }
        }

        Assert.True(joined > 20);
    }

    private JsonElement GpuDrive()
    {
        Folder.Export("gpudrive", simulated.OpenWithRoads());
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/train/0000_0000.json")));
        return document.RootElement.Clone();
    }

    private static Vector3D Point(JsonElement point) =>
        new(point.GetProperty("x").GetDouble(), point.GetProperty("y").GetDouble(), point.GetProperty("z").GetDouble());
}
