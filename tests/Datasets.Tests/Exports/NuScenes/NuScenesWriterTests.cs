using System.Text.Json.Nodes;

namespace Harvester.Datasets.Tests.Exports.NuScenes;

public sealed class NuScenesWriterTests : ExportTests
{
    [Fact]
    public void Annotation_has_its_box_in_the_world()
    {
        JsonObject annotation = Annotations()[0];

        // The car of 2 m on each side is 11 m to the north and looks north: a quarter turn about z, whose w and z are cos and sin of 45.
        Assert.Equal("[0,11,0]", annotation["translation"]!.ToJsonString());
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

    private JsonObject[] Annotations()
    {
        Session.DeterminePedestrians();
        Folder.Export("nuscenes", Session.Open());
        return Table("sample_annotation");
    }

    private JsonObject[] Table(string name) =>
        [.. JsonNode.Parse(File.ReadAllText(Folder.PathOf($"out/v1.0-gta/{name}.json")))!.AsArray().Select(each => each!.AsObject())];
}
