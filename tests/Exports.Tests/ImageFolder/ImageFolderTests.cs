using System.Text.Json.Nodes;
using Harvester.Exports.Validation;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.ImageFolder;

public sealed class ImageFolderTests(SimulatedSession simulated) : CheckTests(simulated, "imagefolder")
{
    private const string Metadata = "data/train/metadata.jsonl";

    [Fact]
    public void Row_has_the_boxes_of_the_labels()
    {
        Session.DeterminePedestrians();
        Folder.Export("imagefolder", Session.Open());

        Assert.Equal(
            """
            {"file_name":"00000000.png","session":0,"frame":0,"weather":"clear","objects":{"bbox":[[38,28,5,5],[70,24,10,12]],
            "categories":[0,6],"track_ids":[1,2]},"ignore_regions":[]}
            """.ReplaceLineEndings(""),
            Folder.Lines("out/" + Metadata)[0]
        );
        Assert.True(File.Exists(Folder.PathOf("out/data/train/00000002.png")));
    }

    [Fact]
    public void Object_that_may_be_hidden_is_an_ignore_region()
    {
        Folder.Export("imagefolder", Session.Open());

        JsonNode row = JsonNode.Parse(Folder.Lines("out/" + Metadata)[0])!;
        Assert.Equal("[[70,24,10,12]]", row["ignore_regions"]!.ToJsonString());
        Assert.Equal("[0]", row["objects"]!["categories"]!.ToJsonString());
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Theory]
    [InlineData("^\\{", "", "invalid JSON at ")]
    [InlineData("00000000.png", "00000099.png", "file_name '00000099.png' is not in data/train.")]
    [InlineData("\"categories\":\\[", "\"categories\":[0,", "bbox, categories and track_ids are not of one length.")]
    [InlineData("\"categories\":\\[\\d+", "\"categories\":[11", "a category is not a whole number from 0 to 10.")]
    [InlineData("\"track_ids\":\\[\\d+,(\\d+)", "\"track_ids\":[$1,$1", "a track id occurs twice.")]
    [InlineData("\"bbox\":\\[\\[[^,]*", "\"bbox\":[[200", "a box does not lie in the image of 200 x 150, or has no area.")]
    public void A_damaged_row_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Metadata, pattern, replacement, $"{Metadata}, line 1: {expected}");

    [Fact]
    public void Image_without_row_and_missing_table_are_found()
    {
        Export();
        Damage(Metadata, "^.*\n", "");
        AssertFound("data/train/00000000.png: metadata.jsonl has no row for it.");
        Delete(Metadata);
        AssertFound($"{Metadata}: it is missing.");
    }
}
