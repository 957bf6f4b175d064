using System.Text.Json.Nodes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Lanes;

public sealed class OpenLaneCheckTests(SimulatedSession simulated) : CheckTests(simulated, "openlane")
{
    private const string Frame = "train/segment-0000/00000006";
    private const string Labels = "lane3d/" + Frame + ".json";

    [Theory]
    [InlineData("^\\{", "", "invalid JSON at ")]
    [InlineData("\"file_path\":\"train", "\"file_path\":\"test", "file_path is not '" + Frame + ".png'.")]
    [InlineData("\"intrinsic\":\\[\\[", "\"intrinsic\":[[-", "intrinsic is not the matrix of a camera.")]
    [InlineData("\"extrinsic\":\\[\\[[^,]*", "\"extrinsic\":[[0.5", "extrinsic is not a rotation and a displacement.")]
    [InlineData("\"visibility\":\\[\\d,", "\"visibility\":[", "lane_lines[0]: uv, xyz and visibility are not of one length.")]
    [InlineData("\"visibility\":\\[\\d,", "\"visibility\":[2,", "lane_lines[0]: a visibility is not 0 or 1.")]
    [InlineData("\"attribute\":\\d", "\"attribute\":7", "lane_lines[0]: its attribute, category or track_id")]
    [InlineData("\"uv\":\\[\\[[^,]*", "\"uv\":[[300", "lane_lines[0]: point 0 does not lie in the image of 200 x 150.")]
    [InlineData("\"xyz\":\\[\\[[^,]*", "\"xyz\":[[1000", "lane_lines[0]: point 0, projected with intrinsic, does not fall onto its pixel.")]
    [InlineData("\"xyz\":\\[\\[", "\"xyz\":[[-", "lane_lines[0]: point 0 lies behind the camera.")]
    public void Damaged_labels_are_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Labels, pattern, replacement, $"{Labels}: {expected}");

    [Fact]
    public void Negated_heights_are_found()
    {
        Export();
        string text = File.ReadAllText(Folder.PathOf("out/" + Labels));
        JsonNode frame = JsonNode.Parse(text)!;
        foreach (JsonNode? line in frame["lane_lines"]!.AsArray())
        {
            JsonArray up = line!["xyz"]![2]!.AsArray();
            for (int i = 0; i < up.Count; i++)
            {
                up[i] = -up[i]!.GetValue<double>();
            }
        }

        File.WriteAllText(Folder.PathOf("out/" + Labels), frame.ToJsonString());
        AssertFound($"{Labels}: lane_lines[0]: point 0, projected with intrinsic, does not fall onto its pixel.");
    }

    [Theory]
    [InlineData(Labels, Labels + ": it is missing, but its image exists.")]
    [InlineData("images/" + Frame + ".png", Labels + ": its image is missing.")]
    [InlineData("train.txt", "*.txt: '" + Frame + ".png' is not in any list.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);
}
