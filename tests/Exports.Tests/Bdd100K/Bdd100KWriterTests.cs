using System.Text.Json.Nodes;
using Harvester.Exports.Validation;

namespace Harvester.Exports.Tests.Bdd100K;

public sealed class Bdd100KWriterTests : ExportTests
{
    [Fact]
    public void Frame_has_its_video_time_and_attributes()
    {
        Folder.Export("bdd100k", [Session.Open(), Session.Open()]);

        JsonNode frame = Frames()[4]!;
        Assert.Equal("00000004.png", (string?)frame["name"]);
        Assert.Equal(("sequence-0001", 1, 1500), ((string?)frame["videoName"], (int)frame["frameIndex"]!, (int)frame["timestamp"]!));
        Assert.Equal((80, 60), ((int)frame["size"]!["width"]!, (int)frame["size"]!["height"]!));
        Assert.Equal("""{"weather":"clear","scene":"undefined","timeofday":"daytime"}""", frame["attributes"]!.ToJsonString());
        Assert.True(File.Exists(Folder.PathOf("out/images/100k/train/00000004.png")));
    }

    [Fact]
    public void Last_pixel_belongs_to_the_box()
    {
        Session.DeterminePedestrians();
        Folder.Export("bdd100k", Session.Open());

        // The car's visible pixels are columns 38 to 42 and rows 28 to 32; a quarter of it is hidden.
        Assert.Equal(
            """
            {"id":"1","category":"car","attributes":{"occluded":true,"truncated":false,"crowd":false,"trafficLightColor":"none"},
            "box2d":{"x1":38,"y1":28,"x2":42,"y2":32}}
            """.ReplaceLineEndings(""),
            Frames()[0]!["labels"]![0]!.ToJsonString()
        );
        Assert.Equal("pedestrian", (string?)Frames()[0]!["labels"]![1]!["category"]);
        Assert.True((bool)Frames()[0]!["labels"]![1]!["attributes"]!["truncated"]!);
    }

    [Fact]
    public void Object_that_may_be_hidden_is_a_crowd()
    {
        Folder.Export("bdd100k", Session.Open());

        JsonNode label = Frames()[0]!["labels"]![1]!;
        Assert.Equal(("ignored-0", true), ((string?)label["id"], (bool)label["attributes"]!["crowd"]!));
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Theory]
    [InlineData("thunder", "04:59:59", "rainy", "night")]
    [InlineData("xmas", "05:00:00", "snowy", "dawn/dusk")]
    [InlineData("clouds", "07:00:00", "partly cloudy", "daytime")]
    [InlineData("smog", "19:00:00", "foggy", "dawn/dusk")]
    [InlineData("halloween", "21:00:00", "undefined", "night")]
    public void Weather_and_time_have_the_names_of_bdd100k(string weather, string time, string expectedWeather, string expectedTime)
    {
        Session.Lines[0]["environment"] = new JsonObject { ["weather"] = weather, ["timeOfDay"] = time };
        Folder.Export("bdd100k", Session.Open());

        JsonNode attributes = Frames()[0]!["attributes"]!;
        Assert.Equal((expectedWeather, expectedTime), ((string?)attributes["weather"], (string?)attributes["timeofday"]));
    }

    private JsonArray Frames() => JsonNode.Parse(File.ReadAllText(Folder.PathOf("out/labels/det_20/det_train.json")))!.AsArray();
}
