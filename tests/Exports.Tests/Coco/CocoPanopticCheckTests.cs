using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Coco;

public sealed class CocoPanopticCheckTests(SimulatedSession simulated) : CheckTests(simulated, "coco-panoptic")
{
    private const string Labels = "annotations/panoptic_train.json";
    private const string Picture = "annotations/panoptic_train/00000000.png";

    [Theory]
    [InlineData(
        "\"segments_info\":\\[\\{\"id\":\\d+",
        "\"segments_info\":[{\"id\":60000",
        "segment 60000 is not in its map, or occurs twice."
    )]
    [InlineData("\"area\":(\\d+)", "\"area\":1$1", "area or bbox of segment 1 differs from its map.")]
    [InlineData("\"bbox\":\\[(\\d+)", "\"bbox\":[1$1", "area or bbox of segment 1 differs from its map.")]
    [InlineData("\"category_id\":\\d+", "\"category_id\":77", "segment 1 has a category that is not listed")]
    [InlineData("\"segments_info\":\\[\\{[^}]*\\},", "\"segments_info\":[", "segment 1 of its map is not listed.")]
    public void A_damaged_segment_is_found_with_its_line(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Labels, pattern, replacement, $"{Labels}, line 10: annotation of image 0: {expected}");

    [Fact]
    public void An_image_without_annotation_and_one_with_two_are_found()
    {
        Export();
        Damage(Labels, "\"image_id\":1,", "\"image_id\":0,");
        AssertFound($"{Labels}, line 11: annotation of image 0: its image already has an annotation.");
        AssertFound($"{Labels}: image 1 has no annotation.");
    }

    [Fact]
    public void A_picture_with_other_pixels_is_found()
    {
        Export();
        PixelBuffer picture = PngDecoder.ReadRgb(Folder.PathOf("out/" + Picture));
        int at = Array.IndexOf(picture.Bytes, (byte)1);
        picture.Bytes[at] = 0;
        Write(picture);
        AssertFound($"{Labels}, line 10: annotation of image 0: area or bbox of segment 1 differs from its map.");
    }

    [Fact]
    public void A_picture_of_another_size_is_found()
    {
        Export();
        Write(new PixelBuffer(new ImageSize(20, 15)));
        AssertFound($"{Labels}, line 10: annotation of image 0: its map is 20 x 15, not 200 x 150.");
    }

    [Theory]
    [InlineData(Picture, Labels + ", line 10: annotation of image 0: '" + Picture + "' is missing.")]
    [InlineData(Labels, Labels + ": it is missing.")]
    public void Missing_file_is_found(string file, string expected) => AssertLossIsFound(file, expected);

    private void Write(PixelBuffer picture)
    {
        using FileStream file = File.Create(Folder.PathOf("out/" + Picture));
        new PngEncoder().Write(picture, file);
    }
}
