using System.Text.Json.Nodes;
using Harvester.Exports.Validation;

namespace Harvester.Exports.Tests.OpenLabel;

public sealed class OpenLabelWriterTests : ExportTests
{
    [Fact]
    public void File_has_version_coordinate_systems_and_camera()
    {
        Folder.Export("openlabel", Session.Open());

        JsonNode root = Root();
        Assert.Equal("1.0.0", (string?)root["metadata"]!["schema_version"]);
        Assert.Equal(
            ["scene_cs", "local_cs", "sensor_cs"],
            ((string[])["world", "ego", "camera"]).Select(name => (string?)root["coordinate_systems"]![name]!["type"])
        );
        Assert.Equal(
            """{"width_px":80,"height_px":60,"camera_matrix":[30,0,40,0,0,30,30,0,0,0,1,0],"distortion_coeffs":[0,0,0,0,0]}""",
            root["streams"]!["camera"]!["stream_properties"]!["intrinsics_pinhole"]!.ToJsonString()
        );
    }

    [Fact]
    public void Object_has_its_box_cuboid_and_velocity()
    {
        Folder.Export("openlabel", Session.Open());

        JsonNode data = Root()["frames"]!["1"]!["objects"]!["1"]!["object_data"]!;

        // 5 x 5 visible pixels from (38, 28): the centre is (40.5, 30.5).
        Assert.Equal("[40.5,30.5,5,5]", data["bbox"]![0]!["val"]!.ToJsonString());

        // x forward is north, the y axis of the world: a quarter turn about z, whose quaternion is (0, 0, sin 45, cos 45).
        Assert.Equal("[0,11,0,0,0,0.707106781,0.707106781,2,2,2]", data["cuboid"]![0]!["val"]!.ToJsonString());
        Assert.Equal("[0,5,0]", data["vec"]![0]!["val"]!.ToJsonString());
    }

    [Fact]
    public void Frames_have_transforms_to_the_world()
    {
        Folder.Export("openlabel", Session.Open());

        JsonNode properties = Root()["frames"]!["2"]!["frame_properties"]!;
        Assert.Equal(
            (2.5, "images/train/0000/00000002.png"),
            ((double)properties["timestamp"]!, (string?)properties["streams"]!["camera"]!["uri"])
        );
        JsonNode ego = properties["transforms"]!["ego_to_world"]!["transform_src_to_dst"]!;
        Assert.Equal("[0,-2,-1]", ego["translation"]!.ToJsonString());

        // Right, down and forward of a camera that looks north are x, -z and y: a quarter turn about -x.
        JsonNode camera = properties["transforms"]!["camera_to_world"]!["transform_src_to_dst"]!;
        Assert.Equal("[-0.707106781,0,0,0.707106781]", camera["quaternion"]!.ToJsonString());
    }

    [Fact]
    public void Objects_list_the_frames_that_have_them()
    {
        Session.DeterminePedestrians();
        Session.Lines[1]["objects"]!.AsArray().RemoveAt(1);
        Folder.Export("openlabel", Session.Open());

        JsonNode objects = Root()["objects"]!;
        Assert.Equal("""[{"frame_start":0,"frame_end":2}]""", objects["1"]!["frame_intervals"]!.ToJsonString());
        Assert.Equal(
            """[{"frame_start":0,"frame_end":0},{"frame_start":2,"frame_end":2}]""",
            objects["2"]!["frame_intervals"]!.ToJsonString()
        );
        Assert.Equal("pedestrian", (string?)objects["2"]!["type"]);
        Assert.Equal("""[{"frame_start":0,"frame_end":2}]""", Root()["frame_intervals"]!.ToJsonString());
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Fact]
    public void Session_without_objects_is_valid()
    {
        Session.Lines.ForEach(line => line["objects"]!.AsArray().Clear());
        Folder.Export("openlabel", Session.Open());

        Assert.Empty(Root()["objects"]!.AsObject());
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    private JsonNode Root() => JsonNode.Parse(File.ReadAllText(Folder.PathOf("out/labels/train/0000.json")))!["openlabel"]!;
}
