using System.Text.Json;
using Harvester.Exports.Assembly;
using Harvester.Exports.Validation;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Tests;

/// <summary>
/// A sign is its face, and its post is a pole where the format has poles. The face is in columns 15 to 24 and rows 15 to 24, the post in
/// columns 19 and 20 and rows 25 to 39.
/// </summary>
public sealed class PartExportTests : ExportTests
{
    private const int FacePixels = 10 * 10;
    private const int PostPixels = 2 * 15;

    public PartExportTests() => Session.AddSign(0);

    [Theory]
    [InlineData(null, "[15,15,10,10] 100")]
    [InlineData(PartSelection.Faces, "[15,15,10,10] 100")]
    [InlineData(PartSelection.None, "[15,15,10,25] 130")]
    [InlineData(PartSelection.All, "[15,15,10,25] 130", "[15,15,10,10] 100")]
    [InlineData(PartSelection.Only, "[15,15,10,10] 100")]
    public void Coco_has_the_face_the_whole_sign_or_both(PartSelection? parts, params string[] expected)
    {
        Folder.Export("coco", Session.Open(), new ExportOptions { Parts = parts });

        using JsonDocument coco = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/annotations/instances_train.json")));
        Assert.Equal(
            expected,
            coco.RootElement.GetProperty("annotations")
                .EnumerateArray()
                .Where(item => item.GetProperty("category_id").GetInt32() == 8)
                .Select(item => $"{item.GetProperty("bbox").GetRawText()} {item.GetProperty("area").GetRawText()}")
        );
        AssertValid();
    }

    [Theory]
    [InlineData(PartSelection.Faces, 20, FacePixels, 17, PostPixels)]
    [InlineData(PartSelection.None, 20, FacePixels + PostPixels, 17, 0)]
    [InlineData(PartSelection.All, 20, FacePixels + PostPixels, 17, 0)]
    [InlineData(PartSelection.Only, 20, FacePixels, 17, 0)]
    public void Cityscapes_labels_the_post_as_a_pole(PartSelection parts, int sign, int signPixels, int pole, int polePixels)
    {
        Folder.Export("cityscapes", Session.Open(), new ExportOptions { Parts = parts });

        InstanceMap labels = PngDecoder.ReadLabelMap(
            Folder.PathOf("out/gtFine/train/session0000/session0000_000000_000000_gtFine_labelIds.png")
        );
        Assert.Equal((signPixels, polePixels), (labels.Ids.Count(id => id == sign), labels.Ids.Count(id => id == pole)));
        AssertValid();
    }

    [Fact]
    public void Panoptic_labels_the_post_as_stuff()
    {
        Folder.Export("coco-panoptic", Session.Open());

        using JsonDocument coco = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/annotations/panoptic_train.json")));
        JsonElement[] segments = [.. coco.RootElement.GetProperty("annotations")[0].GetProperty("segments_info").EnumerateArray()];

        // Car 1, face 4, pole and background: numbers, categories and areas.
        Assert.Equal(
            [(1, 1, 25), (4, 8, FacePixels), (65536, 101, PostPixels), (131072, 102, (80 * 60) - 25 - FacePixels - PostPixels)],
            segments.Select(item =>
                (item.GetProperty("id").GetInt32(), item.GetProperty("category_id").GetInt32(), item.GetProperty("area").GetInt32())
            )
        );
        Assert.Equal(
            ["pole 0", "background 0"],
            coco.RootElement.GetProperty("categories")
                .EnumerateArray()
                .TakeLast(2)
                .Select(item => $"{item.GetProperty("name").GetString()} {item.GetProperty("isthing").GetInt32()}")
        );
        AssertValid();
    }

    [Fact]
    public void Yolo_has_box_and_outline_of_the_face()
    {
        Folder.Export("yolo", Session.Open());
        Folder.Export("yolo-segment", Session.Open(), to: "outlines");

        // Centre (20, 20), size 10 x 10 of 80 x 60.
        Assert.Equal("7 0.25 0.333333 0.125 0.166667", Folder.Lines("out/labels/train/00000000.txt")[1]);
        Assert.Equal(
            ["0.1875 0.25", "0.1875 0.416667", "0.3125 0.25", "0.3125 0.416667"],
            Folder
                .Lines("outlines/labels/train/00000000.txt")[1]
                .Split(' ')
                .Skip(1)
                .Chunk(2)
                .Select(corner => string.Join(' ', corner))
                .Order()
        );
        AssertValid();
    }

    [Fact]
    public void Sign_without_a_known_face_is_exported_whole()
    {
        Session.Lines[0]["objects"]!.AsArray().RemoveAt(3);
        Session.Lines[0]["objects"]![2]!["knownParts"] = 0;
        Folder.Export("yolo", Session.Open());

        // Columns 15 to 24 and rows 15 to 39.
        Assert.Equal("7 0.25 0.458333 0.125 0.416667", Folder.Lines("out/labels/train/00000000.txt")[1]);
    }

    [Fact]
    public void Sign_whose_known_face_is_outside_the_image_is_a_post()
    {
        Session.Lines[0]["objects"]!.AsArray().RemoveAt(3);
        Folder.Export("yolo", Session.Open());
        Folder.Export("cityscapes", Session.Open(), to: "city");

        Assert.Single(Folder.Lines("out/labels/train/00000000.txt"));
        InstanceMap labels = PngDecoder.ReadLabelMap(
            Folder.PathOf("city/gtFine/train/session0000/session0000_000000_000000_gtFine_labelIds.png")
        );
        Assert.Equal(FacePixels + PostPixels, labels.Ids.Count(id => id == 17));
    }

    [Theory]
    [InlineData("coco", null, 1)]
    [InlineData("cityscapes", null, 1)]
    [InlineData("coco", PartSelection.All, 0)]
    [InlineData("csv", null, 0)]
    [InlineData("kitti", null, 0)]
    public void Posts_that_faces_replace_are_counted(string format, PartSelection? parts, int posts)
    {
        ExportResult result = Folder.Export(format, Session.Open(), new ExportOptions { Parts = parts });

        Assert.Equal(posts, result.Posts);
        using JsonDocument header = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/export.json")));
        Assert.Equal(posts, header.RootElement.GetProperty("posts").GetInt32());
    }

    private void AssertValid() => Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
}
