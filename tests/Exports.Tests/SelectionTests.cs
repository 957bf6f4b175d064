using System.Text.Json;
using System.Text.Json.Nodes;
using Harvester.Exports.Assembly;
using Harvester.Exports.Validation;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Tests;

/// <summary>What of a session is exported, as what and with which box. The numbers are those of the hand-written session.</summary>
public sealed class SelectionTests : ExportTests
{
    private const string DontCare = "DontCare -1 -1 -10 69.5 23.5 79 35.5 -1 -1 -1 -1000 -1000 -1000 -10";

    [Fact]
    public void Undetermined_object_is_a_dont_care_region_of_kitti()
    {
        ExportResult result = Folder.Export("kitti", Session.Open());

        string[] lines = Folder.Lines("out/training/label_2/000001.txt");
        Assert.Equal(2, lines.Length);
        Assert.StartsWith("Car ", lines[0], StringComparison.Ordinal);
        Assert.Equal(DontCare, lines[1]);
        Assert.Equal((3, 3), (result.Objects, result.Ignored));
        AssertValid();
    }

    [Fact]
    public void Undetermined_object_is_an_ignore_region_of_tracking()
    {
        Folder.Export("kitti-tracking", Session.Open());

        Assert.Equal(
            "1 -1 DontCare -1 -1 -10 69.5 23.5 79 35.5 -1000 -1000 -1000 -10 -1 -1 -1",
            Folder.Lines("out/training/label_02/0000.txt")[3]
        );
        AssertValid();
    }

    [Fact]
    public void Undetermined_object_is_a_crowd_in_coco()
    {
        Folder.Export("coco", Session.Open());

        JsonElement crowd = Annotations()[1];
        Assert.Equal((7, 1), (crowd.GetProperty("category_id").GetInt32(), crowd.GetProperty("iscrowd").GetInt32()));
        Assert.Equal("[70,24,10,12]", crowd.GetProperty("bbox").GetRawText());

        // Columns 70 to 79, each from row 24 on 12 pixels: 70 · 60 + 24 zeros, 12 ones, 48 zeros, and so on, with 24 zeros after the last.
        int[] counts = [.. crowd.GetProperty("segmentation").GetProperty("counts").EnumerateArray().Select(count => count.GetInt32())];
        Assert.Equal([4224, .. Enumerable.Repeat(0, 9).SelectMany(_ => (int[])[12, 48]), 12, 24], counts);
        AssertValid();
    }

    [Fact]
    public void Undetermined_object_is_difficult_in_voc_and_absent_in_yolo()
    {
        Folder.Export("voc", Session.Open());
        Folder.Export("yolo", Session.Open(), to: "yolo");

        Assert.Equal(
            ["0", "1"],
            System
                .Xml.Linq.XDocument.Load(Folder.PathOf("out/Annotations/00000000.xml"))
                .Descendants("difficult")
                .Select(item => item.Value)
        );
        Assert.Single(Folder.Lines("yolo/labels/train/00000000.txt"));
        AssertValid();
    }

    [Fact]
    public void Recorded_ignore_region_is_marked_in_the_formats_own_way()
    {
        Session.Lines[0]["ignoreRegions"] = JsonNode.Parse(
            """[{ "reason": "beyondRange", "class": "truck", "box2d": [10, 20, 14, 26], "distanceMetres": 157 }]"""
        );
        Session.DeterminePedestrians();
        Folder.Export("kitti", Session.Open(), to: "kitti");
        Folder.Export("voc", Session.Open(), to: "voc");
        Folder.Export("csv", Session.Open(), to: "csv");
        Folder.Export("coco", Session.Open());

        Assert.Equal(
            "DontCare -1 -1 -10 9.5 19.5 13.5 25.5 -1 -1 -1 -1000 -1000 -1000 -10",
            Folder.Lines("kitti/training/label_2/000000.txt")[2]
        );
        System.Xml.Linq.XElement region = System
            .Xml.Linq.XDocument.Load(Folder.PathOf("voc/Annotations/00000000.xml"))
            .Descendants("object")
            .Last();
        Assert.Equal(
            ("truck", "1", "11"),
            (region.Element("name")!.Value, region.Element("difficult")!.Value, region.Element("bndbox")!.Element("xmin")!.Value)
        );
        Assert.Equal(
            ["frame,reason,class,box2d_xmin,box2d_ymin,box2d_xmax,box2d_ymax,distance_metres", "0,beyondRange,truck,10,20,14,26,157"],
            Folder.Lines("csv/ignore_regions.csv")
        );
        JsonElement crowd = Annotations()[1];
        Assert.Equal(
            (2, 1, "[10,20,4,6]"),
            (crowd.GetProperty("category_id").GetInt32(), crowd.GetProperty("iscrowd").GetInt32(), crowd.GetProperty("bbox").GetRawText())
        );
        Assert.All((string[])["out", "kitti", "voc", "csv"], name => Assert.Empty(DatasetValidator.Validate(Folder.PathOf(name)).Problems));
    }

    [Theory]
    [InlineData("csv")]
    [InlineData("webdataset")]
    public void Every_visibility_filter_drops_an_undetermined_object(string format)
    {
        Assert.Equal(6, Folder.Export(format, Session.Open(), to: "all").Objects);
        Assert.Equal(3, Folder.Export(format, Session.Open(), new ExportOptions { MinVisibleFraction = 0.01 }).Objects);
    }

    [Fact]
    public void Undetermined_object_with_pixels_in_the_mask_is_visible()
    {
        Session.Pedestrian(0)["box2dVisible"] = new JsonArray(70, 24, 80, 36);
        Session.PaintMask(0, (1, 38, 28, 43, 33), (2, 70, 24, 80, 36));

        Folder.Export("yolo", Session.Open());

        Assert.Equal(["0 0.50625 0.508333 0.0625 0.083333", "6 0.9375 0.5 0.125 0.2"], Folder.Lines("out/labels/train/00000000.txt"));
    }

    [Fact]
    public void Filtered_object_becomes_an_ignore_region()
    {
        Session.DeterminePedestrians();
        var options = new ExportOptions { MinVisibleFraction = 0.78 };
        Folder.Export("kitti", Session.Open(), options);
        Folder.Export("kitti", Session.Open(), new ExportOptions { Classes = [ObjectClass.Pedestrian] }, "class");

        // The car is seen to 0.75; its visible pixels are columns 38 to 42, which begin 0.5 before their centres.
        Assert.Equal(
            ["Pedestrian", "DontCare -1 -1 -10 37.5 27.5 42.5 32.5 -1 -1 -1 -1000 -1000 -1000 -10"],
            Folder
                .Lines("out/training/label_2/000000.txt")
                .Select(line => line.StartsWith("Pedestrian", StringComparison.Ordinal) ? "Pedestrian" : line)
        );
        Assert.Equal(Folder.Lines("out/training/label_2/000000.txt"), Folder.Lines("class/training/label_2/000000.txt"));
    }

    [Theory]
    // The car: visible columns 38 to 43 of 80 and rows 28 to 33 of 60; cuboid 37 to 43 and 27 to 33; the amodal box is cut at the image's
    // edge.
    [InlineData(BoxKind.Visible, "0 0.50625 0.508333 0.0625 0.083333", "6 0.9375 0.5 0.125 0.2")]
    [InlineData(BoxKind.Cuboid, "0 0.5 0.5 0.075 0.1", "6 0.9375 0.5 0.125 0.2")]
    [InlineData(BoxKind.Amodal, "0 0.5 0.5 0.075 0.1", "6 0.93125 0.5 0.1375 0.2")]
    public void Boxes_are_of_the_requested_kind(BoxKind boxes, string car, string pedestrian)
    {
        Session.DeterminePedestrians();
        Session.Pedestrian(0)["box2dAmodal"]![0] = 69;
        Folder.Export("yolo", Session.Open(), new ExportOptions { Boxes = boxes });

        Assert.Equal([car, pedestrian], Folder.Lines("out/labels/train/00000000.txt"));
    }

    [Fact]
    public void Amodal_boxes_of_coco_reach_beyond_the_image()
    {
        // Without masks: with them, objects without a pixel are left out, and the mask shows none of the pedestrian.
        Session.DeterminePedestrians();
        Session.Lines.ForEach(line => line["mask"] = null);
        Folder.Export("coco", Session.Open(), new ExportOptions { Boxes = BoxKind.Amodal });

        // The pedestrian: columns 70 to 82 of 80.
        Assert.Equal(["[37,27,6,6]", "[70,24,12,12]"], Annotations().Take(2).Select(item => item.GetProperty("bbox").GetRawText()));
        AssertValid();
    }

    [Fact]
    public void Boxes_of_visible_pixels_are_refused_without_masks()
    {
        Session.Lines.ForEach(line => line["mask"] = null);

        DatasetFormatException refused = Assert.Throws<DatasetFormatException>(() =>
            Folder.Export("voc", Session.Open(), new ExportOptions { Boxes = BoxKind.Visible })
        );
        Assert.Contains("need masks", refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Classes_with_one_name_are_one_class()
    {
        Session.DeterminePedestrians();
        var names = new Dictionary<ObjectClass, string>
        {
            [ObjectClass.Car] = "Vehicle",
            [ObjectClass.Truck] = "Vehicle",
            [ObjectClass.Pedestrian] = "Person",
        };
        var options = new ExportOptions
        {
            Names = names,
            Classes = [ObjectClass.Car, ObjectClass.Truck, ObjectClass.Pedestrian],
            Boxes = BoxKind.Cuboid,
        };
        Folder.Export("yolo", Session.Open(), options);
        Folder.Export("csv", Session.Open(), options, "csv");

        Assert.Equal(["  0: Vehicle", "  1: Person"], Folder.Lines("out/data.yaml")[^2..]);
        Assert.Equal(["0", "1"], Folder.Lines("out/labels/train/00000000.txt").Select(line => line[..1]));
        Assert.Contains(",Vehicle,", Folder.Lines("csv/objects.csv")[1], StringComparison.Ordinal);
        AssertValid();
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("csv")).Problems);
    }

    [Fact]
    public void Signs_and_lights_are_classes_of_what_they_show()
    {
        Session.AddSign(0);
        Folder.Export(
            "yolo",
            Session.Open(),
            new ExportOptions { Subclasses = Subclasses.Mutcd | Subclasses.Light, Classes = [ObjectClass.Sign, ObjectClass.TrafficLight] }
        );

        Assert.Equal(
            [
                "  0: sign",
                "  1: sign-R1-1",
                "  2: trafficLight",
                "  3: trafficLight-red",
                "  4: trafficLight-amber",
                "  5: trafficLight-green",
            ],
            Folder.Lines("out/data.yaml")[^6..]
        );
        Assert.Equal("1", Assert.Single(Folder.Lines("out/labels/train/00000000.txt"))[..1]);
        AssertValid();
    }

    [Fact]
    public void Code_of_a_sign_is_an_attribute_of_coco_and_a_column_of_csv()
    {
        Session.AddSign(0);
        Folder.Export("coco", Session.Open());
        Folder.Export("csv", Session.Open(), to: "csv");

        Assert.Contains("R1-1", Annotations().Select(item => item.GetProperty("mutcd").GetString()));
        Assert.EndsWith(",3,R1-1,,,", Folder.Lines("csv/objects.csv")[4], StringComparison.Ordinal);
    }

    private JsonElement[] Annotations() =>
        [
            .. JsonDocument
                .Parse(File.ReadAllText(Folder.PathOf("out/annotations/instances_train.json")))
                .RootElement.GetProperty("annotations")
                .EnumerateArray(),
        ];

    private void AssertValid() => Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
}
