using System.Globalization;
using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Datasets.Exports;
using Harvester.Datasets.Images;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Tests.Exports.Yolo;

[Collection(SimulatedSession.Collection)]
public sealed class YoloWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Boxes_are_centre_and_size_in_shares_of_the_image()
    {
        Folder.Export("yolo", Session.Open());

        // Car: centre (40, 30), size 6 x 6 of 80 x 60. Pedestrian: centre (75, 30), size 10 x 12; class 6 of all.
        Assert.Equal(["0 0.5 0.5 0.075 0.1", "6 0.9375 0.5 0.125 0.2"], Folder.Lines("out/labels/train/00000000.txt"));
        Assert.True(File.Exists(Folder.PathOf("out/images/train/00000000.png")));
    }

    [Fact]
    public void Data_file_numbers_the_exported_classes_and_has_train_and_val()
    {
        Folder.Export("yolo", Session.Open(), new ExportOptions { Classes = [ObjectClass.Pedestrian, ObjectClass.Bus] });

        Assert.Equal(
            ["# Paths are relative to this file.", "train: images/train", "val: images/train", "names:", "  0: bus", "  1: pedestrian"], Folder.Lines("out/data.yaml"));
        Assert.StartsWith("1 ", Assert.Single(Folder.Lines("out/labels/train/00000000.txt")), StringComparison.Ordinal);
    }

    [Fact]
    public void Outlines_span_the_largest_piece_of_the_mask()
    {
        Folder.Export("yolo-segment", simulated.Open());
        int frame = 0;
        foreach (FrameLabel label in simulated.Open().ReadLabels())
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(simulated.Open().PathOf(label.Mask!));
            ObjectLabel[] seen = [.. label.Objects.Where(item => mask.Ids.Contains((ushort)item.Id))];
            string[] lines = Folder.Lines($"out/labels/train/{frame:D8}.txt");
            Assert.Equal(seen.Length, lines.Length);
            foreach ((string line, ObjectLabel item) in lines.Zip(seen))
            {
                double[] numbers = [.. line.Split(' ').Select(word => double.Parse(word, CultureInfo.InvariantCulture))];
                Assert.Equal((int)item.Class, numbers[0]);
                Assert.True(numbers.Length >= 9 && numbers.Length % 2 == 1);
                Assert.All(numbers.Skip(1), number => Assert.InRange(number, 0, 1));
                for (int i = 1; i < numbers.Length; i += 2)
                {
                    // Six decimals of a share of 200 pixels are good to 0.0002 pixels: the corners are whole pixels, within the visible box.
                    const double rounding = 0.001;
                    double x = numbers[i] * mask.Image.Width;
                    double y = numbers[i + 1] * mask.Image.Height;
                    Assert.Equal(Math.Round(x), x, rounding);
                    Assert.InRange(x, item.Box2DVisible!.Value.XMin - rounding, item.Box2DVisible.Value.XMax + rounding);
                    Assert.InRange(y, item.Box2DVisible.Value.YMin - rounding, item.Box2DVisible.Value.YMax + rounding);
                }
            }

            frame++;
        }
    }
}
