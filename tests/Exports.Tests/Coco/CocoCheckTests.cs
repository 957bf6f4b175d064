using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Coco;

public sealed class CocoCheckTests(SimulatedSession simulated) : CheckTests(simulated, "coco")
{
    private const string File = "annotations/instances_train.json";

    /// <summary>The first line is the head, seven are images, one goes on to the annotations.</summary>
    private const int FirstAnnotationLine = 10;

    [Theory]
    [InlineData("\"file_name\":\"00000000", "\"file_name\":\"77777777", "image '77777777.png' is not in images/train.")]
    [InlineData("\"width\":200", "\"width\":300", "image '00000000.png' is 200 x 150, not 300 x 150.")]
    [InlineData("\"width\":200", "\"width\":\"200\"", "images: width must be a whole number")]
    public void A_damaged_image_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(File, pattern, replacement, $"{File}, line 2: {expected}");

    [Theory]
    [InlineData("(\"id\":\\d+),\"image_id\":\\d+", "$1,\"image_id\":99", "its image is not listed.")]
    [InlineData("\"category_id\":\\d+", "\"category_id\":77", "its category is not listed.")]
    [InlineData("\"iscrowd\":0", "\"iscrowd\":2", "iscrowd is not 0 or 1.")]
    [InlineData("\"bbox\":\\[\\d+,(\\d+),", "\"bbox\":[199,$1,", "its box does not lie in the image of 200 x 150")]
    [InlineData("\"bbox\":\\[(\\d+),(\\d+),\\d+", "\"bbox\":[$1,$2,0", "its box does not lie in the image of 200 x 150")]
    [InlineData("\"area\":\\d+", "\"area\":0", "its area is not positive, or larger than its box.")]
    [InlineData("\"area\":\\d+", "\"area\":1", "its run lengths do not add up to its area.")]
    [InlineData("\"counts\":\\[(\\d+),", "\"counts\":[${1}0,", "its run lengths are not those of an image of 200 x 150.")]
    [InlineData("\"size\":\\[150,200\\]", "\"size\":[200,150]", "its run lengths are not those of an image of 200 x 150.")]
    [InlineData("\"bbox\":\\[(\\d+),(\\d+),(\\d+),(\\d+)", "\"bbox\":[$1,$2,$3,${4}.5", "its run lengths do not span its box.")]
    public void A_damaged_annotation_is_found_with_its_line(string pattern, string replacement, string expected)
    {
        Export();
        int id = FirstId();
        Damage(File, pattern, replacement);
        AssertFound($"{File}, line {FirstAnnotationLine}: annotation {id}: {expected}");
    }

    [Fact]
    public void Duplicate_id_is_found()
    {
        Export();
        int id = FirstId();
        Damage(File, "(^\\{\"id\":\\d+,\"image_id\".*\n)", "$1$1");
        AssertFound($"{File}, line {FirstAnnotationLine + 1}: annotation {id}: its id occurs twice");
    }

    [Fact]
    public void Missing_field_is_found()
    {
        Export();
        Damage(File, "\"bbox\":[^\\]]*\\],", "");
        AssertFound($"{File}, line {FirstAnnotationLine}: annotations: bbox is missing.");
    }

    [Fact]
    public void Truncated_file_is_found()
    {
        Export();
        Damage(File, "\"categories\":[\\s\\S]*", "");
        Assert.Contains(Problems(), problem => problem.Contains("invalid JSON at byte", StringComparison.Ordinal));
    }

    [Fact]
    public void A_polygon_that_does_not_span_its_box_is_found()
    {
        Export(Copied with { Segmentation = SegmentationKind.Polygon });
        Assert.Empty(Problems());
        Damage(File, "\"bbox\":\\[(\\d+),(\\d+),(\\d+),(\\d+)", "\"bbox\":[$1,$2,$3,${4}.5");
        AssertFound($"{File}, line {FirstAnnotationLine}: annotation {FirstId()}: its polygons do not span its box.");
    }

    [Fact]
    public void A_polygon_of_a_point_is_found()
    {
        Export(Copied with { Segmentation = SegmentationKind.Polygon });
        Damage(File, "\"segmentation\":\\[\\[(\\d+),(\\d+),[^\\]]*", "\"segmentation\":[[$1,$2");
        AssertFound($"{File}, line {FirstAnnotationLine}: annotation {FirstId()}: a polygon does not have three corners");
    }

    [Fact]
    public void Images_that_are_not_listed_or_in_two_splits_are_found()
    {
        Export(TwoSplits);
        string image = Directory.EnumerateFiles(Folder.PathOf("out/images/train")).Select(Path.GetFileName).Order().First()!;
        Copy($"images/train/{image}", $"images/val/{image}");
        AssertFound($"images/val/{image}: it is not listed in annotations/instances_val.json.");
        Damage("annotations/instances_val.json", "\"file_name\":\"[^\"]*", $"\"file_name\":\"{image}");
        AssertFound($"annotations/instances_val.json, line 2: image '{image}' occurs twice, here or in another split.");
    }

    [Theory]
    [InlineData(File, File + ": it is missing.")]
    [InlineData("images/train/00000004.png", File + ", line 6: image '00000004.png' is not in images/train.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    private int FirstId() =>
        int.Parse(
            Folder.Lines("out/" + File)[FirstAnnotationLine - 1].Split(':', ',')[1],
            System.Globalization.CultureInfo.InvariantCulture
        );
}
