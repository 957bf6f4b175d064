using System.Text.Json;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Coco;

[Collection(SimulatedSession.Collection)]
public sealed class CocoWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Run_lengths_boxes_and_areas_are_those_of_the_masks()
    {
        Folder.Export("coco", simulated.Open());
        using JsonDocument coco = Read("out/annotations/instances_train.json");
        ILookup<int, JsonElement> annotations = coco
            .RootElement.GetProperty("annotations")
            .EnumerateArray()
            .Where(IsObject)
            .ToLookup(item => item.GetProperty("image_id").GetInt32());
        int frame = 0;
        foreach (FrameLabel label in simulated.Open().ReadLabels())
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(simulated.Open().PathOf(label.Mask!));
            int[] seen = [.. mask.Ids.Where(id => id != 0).Select(id => (int)id).Distinct().Order()];
            Assert.Equal(seen, annotations[frame].Select(item => item.GetProperty("track_id").GetInt32()).Order());
            foreach (JsonElement item in annotations[frame])
            {
                AssertSame(mask, item);
            }

            frame++;
        }
    }

    [Fact]
    public void Images_are_listed_with_size_and_lie_where_the_split_is()
    {
        Folder.Export("coco", simulated.Open(), new ExportOptions { Splits = new SplitPlan([new("train", 0.5), new("val", 0.5)], 5, 1) });

        int images = 0;
        foreach (string split in (string[])["train", "val"])
        {
            using JsonDocument coco = Read($"out/annotations/instances_{split}.json");
            foreach (JsonElement image in coco.RootElement.GetProperty("images").EnumerateArray())
            {
                images++;
                ImageHeader header = ImageHeader.Read(Folder.PathOf($"out/images/{split}/{image.GetProperty("file_name").GetString()}"));
                Assert.Equal(header.Size.Width, image.GetProperty("width").GetInt32());
                Assert.Equal(header.Size.Height, image.GetProperty("height").GetInt32());
            }
        }

        Assert.Equal(SimulatedSession.Frames, images);
    }

    [Fact]
    public void Ids_are_unique_and_categories_are_declared()
    {
        Folder.Export("coco", [simulated.Open(), simulated.Open()]);
        using JsonDocument coco = Read("out/annotations/instances_train.json");
        JsonElement[] annotations = [.. coco.RootElement.GetProperty("annotations").EnumerateArray()];
        HashSet<int> categories =
        [
            .. coco.RootElement.GetProperty("categories").EnumerateArray().Select(item => item.GetProperty("id").GetInt32()),
        ];
        HashSet<int> images =
        [
            .. coco.RootElement.GetProperty("images").EnumerateArray().Select(item => item.GetProperty("id").GetInt32()),
        ];

        Assert.Equal(annotations.Length, annotations.Select(item => item.GetProperty("id").GetInt64()).Distinct().Count());
        Assert.All(annotations, item => Assert.Contains(item.GetProperty("category_id").GetInt32(), categories));
        Assert.All(annotations, item => Assert.Contains(item.GetProperty("image_id").GetInt32(), images));
        Assert.Equal(2 * SimulatedSession.Frames, images.Count);
    }

    [Fact]
    public void Polygons_span_the_box()
    {
        Folder.Export("coco", simulated.Open(), new ExportOptions { Segmentation = SegmentationKind.Polygon });
        using JsonDocument coco = Read("out/annotations/instances_train.json");

        foreach (JsonElement item in coco.RootElement.GetProperty("annotations").EnumerateArray().Where(IsObject))
        {
            double[] box = Doubles(item.GetProperty("bbox"));
            double[][] polygons = [.. item.GetProperty("segmentation").EnumerateArray().Select(Doubles)];
            double[] xs = [.. polygons.SelectMany(polygon => polygon.Where((_, i) => i % 2 == 0))];
            double[] ys = [.. polygons.SelectMany(polygon => polygon.Where((_, i) => i % 2 == 1))];

            Assert.All(polygons, polygon => Assert.True(polygon.Length >= 8 && polygon.Length % 2 == 0));
            Assert.Equal(box, (double[])[xs.Min(), ys.Min(), xs.Max() - xs.Min(), ys.Max() - ys.Min()]);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    public void Polygons_cover_exactly_the_pixels_of_holes_and_islands(int hole)
    {
        // A square with a hole, in which lies a square with a hole.
        Session.DeterminePedestrians();
        for (int frame = 0; frame < 3; frame++)
        {
            Session.PaintMask(frame, (1, 30, 20, 55, 45), (0, 33, 23, 52, 42), (1, 35, 25, 45, 35), (0, 36, 26, 36 + hole, 26 + hole));
        }

        Session.Lines.ForEach(line => line["objects"]![0]!["box2dVisible"] = new System.Text.Json.Nodes.JsonArray(30, 20, 55, 45));
        Folder.Export("coco", Session.Open(), new ExportOptions { Segmentation = SegmentationKind.Polygon });
        using JsonDocument coco = Read("out/annotations/instances_train.json");
        InstanceMap mask = PngDecoder.ReadInstanceMap(Session.PathOf("masks/00000000.png"));
        JsonElement car = coco.RootElement.GetProperty("annotations").EnumerateArray().First(IsObject);
        double[][] polygons = [.. car.GetProperty("segmentation").EnumerateArray().Select(Doubles)];

        int both = 0;
        int either = 0;
        for (int at = 0; at < mask.Ids.Length; at++)
        {
            bool isDrawn = polygons.Any(polygon => IsInside(polygon, (at % mask.Image.Width) + 0.5, (at / mask.Image.Width) + 0.5));
            both += isDrawn && mask.Ids[at] == 1 ? 1 : 0;
            either += isDrawn || mask.Ids[at] == 1 ? 1 : 0;
        }

        Assert.Equal((either, 2), (both, polygons.Length));
        Assert.Equal((25 * 25) - (19 * 19) + (10 * 10) - (hole * hole), either);
        Assert.Empty(Harvester.Exports.Validation.DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    /// <summary>The even-odd rule, by which COCO's API fills a polygon.</summary>
    private static bool IsInside(double[] polygon, double x, double y)
    {
        int crossings = 0;
        for (int i = 0; i < polygon.Length; i += 2)
        {
            (double x1, double y1) = (polygon[i], polygon[i + 1]);
            (double x2, double y2) = (polygon[(i + 2) % polygon.Length], polygon[(i + 3) % polygon.Length]);
            crossings += y1 > y != y2 > y && x < x1 + ((x2 - x1) * (y - y1) / (y2 - y1)) ? 1 : 0;
        }

        return crossings % 2 == 1;
    }

    [Fact]
    public void Without_masks_boxes_equal_the_labels_without_segmentation()
    {
        Session.DeterminePedestrians();
        Session.Lines.ForEach(line => line["mask"] = null);
        Folder.Export("coco", Session.Open());
        using JsonDocument coco = Read("out/annotations/instances_train.json");

        JsonElement pedestrian = coco.RootElement.GetProperty("annotations")[1];
        Assert.Equal([70, 24, 10, 12], Doubles(pedestrian.GetProperty("bbox")));
        Assert.Equal(120, pedestrian.GetProperty("area").GetDouble());
        Assert.Equal(0, pedestrian.GetProperty("iscrowd").GetInt32());
        Assert.Equal(0, pedestrian.GetProperty("segmentation").GetArrayLength());
    }

    private static bool IsObject(JsonElement annotation) => annotation.GetProperty("iscrowd").GetInt32() == 0;

    private static double[] Doubles(JsonElement list) => [.. list.EnumerateArray().Select(number => number.GetDouble())];

    /// <summary>Decodes the run lengths as the format's API does: column-major, starting with zeros.</summary>
    private static void AssertSame(InstanceMap mask, JsonElement item)
    {
        int id = item.GetProperty("track_id").GetInt32();
        JsonElement segmentation = item.GetProperty("segmentation");
        int height = segmentation.GetProperty("size")[0].GetInt32();
        int width = segmentation.GetProperty("size")[1].GetInt32();
        Assert.Equal((mask.Image.Height, mask.Image.Width), (height, width));
        int at = 0;
        int area = 0;
        bool inside = false;
        int xMin = width,
            yMin = height,
            xMax = 0,
            yMax = 0;
        foreach (int count in segmentation.GetProperty("counts").EnumerateArray().Select(count => count.GetInt32()))
        {
            for (int end = at + count; at < end; at++)
            {
                (int x, int y) = (at / height, at % height);
                Assert.Equal(inside, mask[x, y] == id);
                if (inside)
                {
                    area++;
                    (xMin, yMin, xMax, yMax) = (Math.Min(xMin, x), Math.Min(yMin, y), Math.Max(xMax, x), Math.Max(yMax, y));
                }
            }

            inside = !inside;
        }

        Assert.Equal(width * height, at);
        Assert.Equal(area, item.GetProperty("area").GetInt32());
        Assert.Equal([xMin, yMin, xMax + 1 - xMin, yMax + 1 - yMin], Doubles(item.GetProperty("bbox")));
    }

    private JsonDocument Read(string name) => JsonDocument.Parse(File.ReadAllText(Folder.PathOf(name)));
}
