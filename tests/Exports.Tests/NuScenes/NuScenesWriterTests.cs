using System.Text.Json.Nodes;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Roads;

namespace Harvester.Exports.Tests.NuScenes;

public sealed class NuScenesWriterTests : ExportTests
{
    [Fact]
    public void Annotation_has_its_box_in_the_world()
    {
        JsonObject annotation = Annotations()[0];

        // The car of 2 m on each side is 11 m to the north and looks north: a quarter turn about z, whose w and z are cos and sin of 45.
        // The map begins 120 m to the west and south of the vehicle, whose origin is at (0, -2): 100 m of roads, and 20 m more.
        Assert.Equal("[120,133,0]", annotation["translation"]!.ToJsonString());
        Assert.Equal("[2,2,2]", annotation["size"]!.ToJsonString());
        Assert.Equal("[0.707106781,0,0,0.707106781]", annotation["rotation"]!.ToJsonString());
        Assert.Equal((0, 0), ((int)annotation["num_lidar_pts"]!, (int)annotation["num_radar_pts"]!));
    }

    [Fact]
    public void Annotations_of_an_object_form_a_chain()
    {
        JsonObject[] annotations = Annotations();
        string instance = (string)annotations[0]["instance_token"]!;
        JsonObject[] chain = [.. annotations.Where(each => (string)each["instance_token"]! == instance)];

        Assert.Equal(3, chain.Length);
        Assert.Equal(["", .. chain.Take(2).Select(each => (string)each["token"]!)], chain.Select(each => (string)each["prev"]!));
        JsonObject listed = Table("instance").Single(each => (string)each["token"]! == instance);
        Assert.Equal((3, (string)chain[2]["token"]!), ((int)listed["nbr_annotations"]!, (string)listed["last_annotation_token"]!));
    }

    [Fact]
    public void Camera_looks_along_z_with_y_down()
    {
        Folder.Export("nuscenes", Session.Open());
        JsonObject camera = Assert.Single(Table("calibrated_sensor"));

        // The camera looks where the car does. Its x, y and z are the car's -y, -z and x: the quaternion of nuScenes' front camera.
        Assert.Equal("[0.5,-0.5,0.5,-0.5]", camera["rotation"]!.ToJsonString());
        Assert.Equal("[[30,0,40],[0,30,30],[0,0,1]]", camera["camera_intrinsic"]!.ToJsonString());
    }

    [Fact]
    public void Data_of_each_frame_is_a_sample()
    {
        Folder.Export("nuscenes", Session.Open());

        JsonObject[] data = Table("sample_data");
        Assert.Equal([true, true, true], data.Select(each => (bool)each["is_key_frame"]!));
        Assert.All(data, each => Assert.True(File.Exists(Folder.PathOf($"out/{each["filename"]}"))));
        Assert.Equal("""{"gta_train":["scene-2001"]}""", File.ReadAllText(Folder.PathOf("out/v1.0-gta/splits.json")).Trim());
    }

    [Fact]
    public void Offset_of_the_map_leads_back_to_the_world()
    {
        JsonObject[] annotations = Annotations();
        JsonObject map = Assert.Single(Table("map_offset"));

        Assert.Equal("[120,122]", map["offset"]!.ToJsonString());
        Assert.Equal("[240,240]", map["size"]!.ToJsonString());
        Assert.Equal((string)Table("map")[0]["filename"]!, (string)map["filename"]!);
        Assert.Equal((string)Table("log")[0]["token"]!, (string)map["log_token"]!);
        Assert.Equal(11, (double)annotations[0]["translation"]![1]! - (double)map["offset"]![1]!);
    }

    [Fact]
    public void Without_roads_the_ground_below_the_vehicle_is_drivable()
    {
        Annotations();
        InstanceMap mask = PngDecoder.ReadLabelMap(Folder.PathOf("out/maps/scene-2001.png"));

        Assert.Equal((2400, 2400), (mask.Image.Width, mask.Image.Height));

        // The vehicle stands at (120, 120): 3 m by 6 m around it are columns 1185 to 1215 and rows 1170 to 1230.
        Assert.Equal(255, mask.Ids[(1200 * 2400) + 1200]);
        Assert.Equal(255, mask.Ids[(1172 * 2400) + 1187]);
        Assert.Equal(0, mask.Ids[(1160 * 2400) + 1200]);
        Assert.Equal(0, mask.Ids[(1200 * 2400) + 1220]);
    }

    [Fact]
    public void Session_with_roads_has_the_map_of_its_scene()
    {
        // A road along the way of the vehicle, which drives north at x = 0, and one too far away to be on the map.
        var network = new RoadNetwork(
            [
                new RoadNode(1, 0, new Vector3D(-2.7, -90, 0), "", RoadNodeFlags.None),
                new RoadNode(1, 1, new Vector3D(-2.7, 90, 0), "", RoadNodeFlags.None),
                new RoadNode(1, 2, new Vector3D(900, 0, 0), "", RoadNodeFlags.None),
                new RoadNode(1, 3, new Vector3D(900, 90, 0), "", RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None), new RoadLink(2, 3, 1, 1, null, RoadLinkFlags.None)]
        );
        Directory.CreateDirectory(Session.PathOf("scenes"));
        using (StreamWriter text = File.CreateText(Session.PathOf("scenes/roads.csv")))
        {
            RoadCsvWriter.Write(network, text);
        }

        Annotations();
        string location = (string)Assert.Single(Table("log"))["location"]!;
        JsonNode map = JsonNode.Parse(File.ReadAllText(Folder.PathOf($"out/maps/expansion/{location}.json")))!;
        JsonNode offset = Table("map_offset")[0];

        Assert.Equal("singapore-onenorth", location);
        Assert.Equal(offset["offset"]!.ToJsonString(), map["offset"]!.ToJsonString());
        Assert.Equal(offset["size"]!.ToJsonString(), map["canvas_edge"]!.ToJsonString());
        Assert.Equal(["1:0-1:1/f0", "1:0-1:1/b0"], map["lane"]!.AsArray().Select(lane => (string)lane!["token"]!));

        // Lanes of 5.4 m: the middle of the lane to the north is at x = 0.
        JsonNode arc = Assert.Single(map["arcline_path_3"]!["1:0-1:1/f0"]!.AsArray())!;
        Assert.Equal([120.0, 32, 1.570796327], arc["start_pose"]!.AsArray().Select(number => (double)number!));
    }

    private JsonObject[] Annotations()
    {
        Session.DeterminePedestrians();
        Folder.Export("nuscenes", Session.Open());
        return Table("sample_annotation");
    }

    private JsonObject[] Table(string name) =>
        [.. JsonNode.Parse(File.ReadAllText(Folder.PathOf($"out/v1.0-gta/{name}.json")))!.AsArray().Select(each => each!.AsObject())];
}
