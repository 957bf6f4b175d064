using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Yolo;

[Collection(SimulatedSession.Collection)]
public sealed class YoloWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Boxes_are_centre_and_size_in_fractions_of_the_image()
    {
        Session.DeterminePedestrians();
        Folder.Export("yolo", Session.Open(), new ExportOptions { Boxes = BoxKind.Cuboid });

        // Car: centre (40, 30), size 6 x 6 of 80 x 60. Pedestrian: centre (75, 30), size 10 x 12; class 6 of all.
        Assert.Equal(["0 0.5 0.5 0.075 0.1", "6 0.9375 0.5 0.125 0.2"], Folder.Lines("out/labels/train/00000000.txt"));
        Assert.True(File.Exists(Folder.PathOf("out/images/train/00000000.png")));
    }

    [Fact]
    public void Data_file_numbers_the_exported_classes_and_has_train_and_val()
    {
        Session.DeterminePedestrians();
        Folder.Export("yolo", Session.Open(), new ExportOptions { Classes = [ObjectClass.Pedestrian, ObjectClass.Bus] });

        Assert.Equal(
            ["# Paths are relative to this file.", "train: images/train", "val: images/train", "names:", "  0: bus", "  1: pedestrian"],
            Folder.Lines("out/data.yaml")
        );
        Assert.StartsWith("1 ", Assert.Single(Folder.Lines("out/labels/train/00000000.txt")), StringComparison.Ordinal);
    }

    [Fact]
    public void Data_file_quotes_names_that_yaml_would_not_read_as_strings()
    {
        Session.DeterminePedestrians();
        Folder.Export(
            "yolo",
            Session.Open(),
            new ExportOptions
            {
                Classes = [ObjectClass.Pedestrian, ObjectClass.Bus],
                Names = new Dictionary<ObjectClass, string> { [ObjectClass.Pedestrian] = "no", [ObjectClass.Bus] = "12" },
                Splits = new SplitPlan([new DatasetSplit("on", 1)], 0, 1),
            }
        );

        Assert.Equal(
            [
                "# Paths are relative to this file.",
                "'on': images/on",
                "train: images/on",
                "val: images/on",
                "names:",
                "  0: '12'",
                "  1: 'no'",
            ],
            Folder.Lines("out/data.yaml")
        );
    }

    [Fact]
    public void Outline_of_an_object_in_pieces_joins_them()
    {
        // Two bars and a frame with a hole, of one object.
        Session.PaintMask(0, (1, 10, 10, 12, 30), (1, 20, 12, 23, 20), (1, 40, 5, 60, 25), (9, 45, 10, 55, 20));
        Folder.Export("yolo-segment", Session.Open());

        InstanceMap mask = PngDecoder.ReadInstanceMap(Session.PathOf("masks/00000000.png"));
        Assert.Equal(
            mask.Ids.Select(id => id == 1),
            Covered(Corners(Folder.Lines("out/labels/train/00000000.txt")[0], mask.Image), mask.Image)
        );
    }

    [Fact]
    public void Outlines_cover_the_pixels_of_the_mask()
    {
        Folder.Export("yolo-segment", simulated.Open());
        int frame = 0;
        foreach (FrameLabel label in simulated.Open().ReadLabels())
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(simulated.Open().PathOf(label.Mask!));
            ObjectLabel[] seen = [.. label.Objects.Where(item => mask.Ids.Contains((ushort)item.Id))];
            string[] lines = Folder.Lines($"out/labels/train/{frame:D8}.txt");
            Assert.Equal(
                seen.Select(item => (int)item.Class),
                lines.Select(line => int.Parse(line.Split(' ')[0], CultureInfo.InvariantCulture))
            );
            foreach ((string line, ObjectLabel item) in lines.Zip(seen))
            {
                Assert.True(mask.Ids.Select(id => id == item.Id).SequenceEqual(Covered(Corners(line, mask.Image), mask.Image)), line);
            }

            frame++;
        }
    }

    private static Vector2D[] Corners(string line, ImageSize image) =>
        [
            .. line.Split(' ')
                .Skip(1)
                .Select(word => double.Parse(word, CultureInfo.InvariantCulture))
                .Chunk(2)
                .Select(corner => new Vector2D(corner[0] * image.Width, corner[1] * image.Height)),
        ];

    /// <summary>For each pixel whether its centre has an odd number of the polygon's sides on its left.</summary>
    private static IEnumerable<bool> Covered(Vector2D[] corners, ImageSize image)
    {
        (Vector2D From, Vector2D To)[] sides = [.. corners.Select((corner, i) => (corner, corners[(i + 1) % corners.Length]))];
        for (int row = 0; row < image.Height; row++)
        {
            double y = row + 0.5;
            double[] crossings =
            [
                .. sides
                    .Where(side => side.From.Y < y != side.To.Y < y)
                    .Select(side => side.From.X + ((side.To.X - side.From.X) * (y - side.From.Y) / (side.To.Y - side.From.Y))),
            ];
            for (int column = 0; column < image.Width; column++)
            {
                yield return crossings.Count(x => x < column + 0.5) % 2 == 1;
            }
        }
    }
}
