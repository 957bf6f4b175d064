using System.Xml.Linq;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Exports.Tests.Voc;

public sealed class VocWriterTests : ExportTests
{
    [Fact]
    public void Annotation_has_the_fields_of_the_development_kit()
    {
        Session.DeterminePedestrians();
        Folder.Export("voc", Session.Open());

        XElement annotation = XDocument.Load(Folder.PathOf("out/Annotations/00000001.xml")).Root!;
        Assert.Equal("annotation", annotation.Name);
        Assert.Equal("00000001.png", annotation.Element("filename")!.Value);
        Assert.Equal(("80", "60", "3"), (Size("width"), Size("height"), Size("depth")));
        XElement pedestrian = annotation.Elements("object").ElementAt(1);
        Assert.Equal("pedestrian", pedestrian.Element("name")!.Value);
        // 0.2 of it lie outside, which is more than 0.15; nothing hides it.
        Assert.Equal("1", pedestrian.Element("truncated")!.Value);
        Assert.Equal("0", pedestrian.Element("occluded")!.Value);
        Assert.Equal("0", pedestrian.Element("difficult")!.Value);
        Assert.Equal("1", annotation.Element("object")!.Element("occluded")!.Value);

        string Size(string name) => annotation.Element("size")!.Element(name)!.Value;
    }

    [Theory]
    // Whole pixels: columns 37 to 42, from 1 on 38 to 43.
    [InlineData(37, 43, "38", "43")]
    // The image's edges are 1 and the width.
    [InlineData(0, 80, "1", "80")]
    // Parts of pixels count as pixels: 37.9 lies in the 38th, 42.1 in the 43rd.
    [InlineData(37.9, 42.1, "38", "43")]
    public void Boxes_count_pixels_from_one_and_include_the_last(double xMin, double xMax, string first, string last)
    {
        Session.Car(0)["box2d"]![0] = xMin;
        Session.Car(0)["box2d"]![2] = xMax;
        Folder.Export("voc", Session.Open(), new ExportOptions { Boxes = BoxKind.Cuboid });

        XElement box = XDocument.Load(Folder.PathOf("out/Annotations/00000000.xml")).Descendants("bndbox").First();
        Assert.Equal(
            (first, "28", last, "33"),
            (box.Element("xmin")!.Value, box.Element("ymin")!.Value, box.Element("xmax")!.Value, box.Element("ymax")!.Value)
        );
    }

    [Fact]
    public void Label_map_lists_the_classes_with_colours()
    {
        Folder.Export("voc", Session.Open(), new ExportOptions { Classes = [ObjectClass.Car, ObjectClass.Sign] });

        string[] lines = Folder.Lines("out/labelmap.txt");
        Assert.Equal(["# label:color_rgb:parts:actions", "background:0,0,0::"], lines[..2]);
        Assert.Equal(2, lines[2..].Length);
        Assert.Matches("^car:[0-9]+,[0-9]+,[0-9]+::$", lines[2]);
        Assert.Matches("^sign:[0-9]+,[0-9]+,[0-9]+::$", lines[3]);
    }

    [Fact]
    public void Image_sets_list_the_frames()
    {
        Folder.Export("voc", Session.Open());

        Assert.Equal(["00000000", "00000001", "00000002"], Folder.Lines("out/ImageSets/Main/train.txt"));
    }
}
