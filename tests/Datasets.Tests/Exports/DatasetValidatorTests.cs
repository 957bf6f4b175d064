using Harvester.Datasets.Exports;
using Harvester.Datasets.Exports.Validation;

namespace Harvester.Datasets.Tests.Exports;

[Collection(SimulatedSession.Collection)]
public sealed class DatasetValidatorTests(SimulatedSession simulated) : IDisposable
{
    private readonly ExportFolder _folder = new();

    public static TheoryData<string> Formats => [.. DatasetFormats.All.Select(format => format.Name)];

    public void Dispose() => _folder.Dispose();

    [Theory]
    [MemberData(nameof(Formats))]
    public void Validate_of_an_export_finds_nothing(string format)
    {
        _folder.Export(format, simulated.Open());

        Assert.Empty(DatasetValidator.Validate(_folder.PathOf("out")).Problems);
    }

    [Theory]
    [InlineData("kitti", "training/label_2/000001.txt", "Car 0 0 0 1 1 2 2 1 1 1 0 0 5", "training/label_2/000001.txt, line 1: it has 14 columns instead of 15.")]
    [InlineData("kitti", "training/label_2/000001.txt", "Car 0 0 0 1 1 200 2 1 1 1 0 0 5 0", "its box does not lie in the image of 200 x 150.")]
    [InlineData("kitti", "training/label_2/000001.txt", "Car 0 4 0 1 1 2 2 1 1 1 0 0 5 0", "occluded is not")]
    [InlineData("kitti", "training/label_2/000001.txt", "Car 0 0 x 1 1 2 2 1 1 1 0 0 5 0", "is not a number")]
    [InlineData("yolo", "labels/train/00000002.txt", "10 0.5 0.5 0.1 0.1", "class 10 is none of the 10")]
    [InlineData("yolo", "labels/train/00000002.txt", "1 0.5 0.5 1.1 0.1", "a place is not 0 to 1")]
    [InlineData("yolo-segment", "labels/train/00000002.txt", "1 0.5 0.5 0.1 0.1 0.2", "it has 6 numbers")]
    [InlineData("coco", "annotations/instances_train.json", "{", "annotations/instances_train.json: ")]
    [InlineData("coco", "annotations/instances_train.json", """{"images":[{"id":1,"width":9,"height":9,"file_name":"x.png"}],"categories":[],"annotations":[]}""", "'x.png' is not in images/train")]
    [InlineData("coco", "annotations/instances_train.json", """{"images":[],"categories":[],"annotations":[{"id":1,"image_id":3}]}""", "annotation 1: its image is not listed")]
    public void Validate_of_a_damaged_label_says_what_is_wrong(string format, string file, string content, string message)
    {
        _folder.Export(format, simulated.Open());
        File.WriteAllText(_folder.PathOf("out/" + file), content + "\n");

        Assert.Contains(message, Assert.Single(DatasetValidator.Validate(_folder.PathOf("out")).Problems).ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Validate_finds_images_that_are_gone_or_cut_off()
    {
        _folder.Export("kitti", simulated.Open(), new ExportOptions { Images = ImageTransfer.Copy });
        File.Delete(_folder.PathOf("out/training/image_2/000001.png"));
        Assert.Contains("7 frames, but there are 6 images", Assert.Single(DatasetValidator.Validate(_folder.PathOf("out")).Problems).Message, StringComparison.Ordinal);

        File.WriteAllBytes(_folder.PathOf("out/training/image_2/000001.png"), TestImages.Png(200, 150)[..40]);
        Assert.Contains(DatasetValidator.Validate(_folder.PathOf("out")).Problems, problem => problem.Message.Contains("cut off", StringComparison.Ordinal));
    }
}
