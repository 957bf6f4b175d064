using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.OpenLaneV2;

public sealed class OpenLaneV2CheckTests(SimulatedSession simulated) : CheckTests(simulated, "openlane-v2")
{
    private const string Index = "data_dict_gta.json";

    [Theory]
    [InlineData(".json", "^\\{", "", "invalid JSON at ")]
    [InlineData(".json", "\"timestamp\":1", "\"timestamp\":2", "timestamp is not that of its name.")]
    [InlineData(".json", "\"image_path\":\"train", "\"image_path\":\"test", "its image 'test/")]
    [InlineData(".json", "\"rotation\":\\[\\[[^,]*", "\"rotation\":[[0.5", "extrinsic is not a rotation and a displacement.")]
    [InlineData(".json", "\"points\":\\[\\[[^,]*", "\"points\":[[51", "lane_centerline[0] has points out of range, or fewer than two.")]
    [InlineData(".json", "\"topology_lclc\":\\[\\[\\d,", "\"topology_lclc\":[[", "topology_lclc is not a matrix of 0 and 1 of its lanes.")]
    [InlineData(
        "-ls.json",
        "\"topology_lsls\":\\[\\[\\d",
        "\"topology_lsls\":[[2",
        "topology_lsls is not a matrix of 0 and 1 of its lanes."
    )]
    [InlineData("-ls.json", "\"left_laneline_type\":\\d", "\"left_laneline_type\":3", "the type of a lane line is not 0, 1 or 2.")]
    [InlineData("-ls.json", "\"category\":2", "\"category\":3", "an area has an unknown category or points out of range.")]
    public void Damaged_frames_are_found(string suffix, string pattern, string replacement, string expected)
    {
        Export();
        string file = Frame(suffix);
        Damage(file, pattern, replacement);
        AssertFound($"{file}: {expected}");
    }

    [Fact]
    public void Elements_outside_the_image_are_found()
    {
        Export();
        string file = Frame("-ls.json");
        JsonNode frame = JsonNode.Parse(File.ReadAllText(Folder.PathOf("out/" + file)))!;
        JsonArray lanes = frame["annotation"]!["lane_segment"]!.AsArray();
        frame["annotation"]!["traffic_element"] = JsonNode.Parse(
            """[{"id": 1, "category": 1, "attribute": 1, "points": [[10, 10], [300, 20]]}]"""
        );
        frame["annotation"]!["topology_lste"] = new JsonArray([.. lanes.Select(_ => (JsonNode)new JsonArray(0))]);
        File.WriteAllText(Folder.PathOf("out/" + file), frame.ToJsonString());

        AssertFound($"{file}: traffic_element[0] does not lie in the image of 200 x 150.");
    }

    [Fact]
    public void Missing_frames_are_found()
    {
        Export();
        string file = Frame("-ls.json");
        Delete(file);
        AssertFound($"{file}: it is missing, but {Index} lists its frame.");
    }

    [Fact]
    public void Frame_that_cannot_be_read_is_found()
    {
        Export();
        string file = Frame("-ls.json");

        // The check of the manifest would not go on.
        Delete("manifest.jsonl");
        using FileStream held = new(Folder.PathOf("out/" + file), FileMode.Open, FileAccess.ReadWrite, FileShare.None);
        AssertFound($"{file}: ");
    }

    [Fact]
    public void Missing_index_is_found()
    {
        Export();
        Delete(Index);
        AssertFound(Index + ": ");
    }

    private string Frame(string suffix)
    {
        using JsonDocument index = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/" + Index)));
        JsonProperty segment = index.RootElement.GetProperty("train").EnumerateObject().First();
        return $"train/{segment.Name}/info/{segment.Value[0].GetString()![..^5]}{suffix}";
    }
}
