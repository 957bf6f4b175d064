using System.Text.Json.Nodes;
using Harvester.Exports.Validation;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Semantics;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Semantics;

/// <summary>Exports of class maps agree with them, pixel by pixel.</summary>
public sealed class SemanticExportTests : IDisposable
{
    private readonly SemanticSession _session = new(SemanticsMethod.Rays);
    private readonly ExportFolder _folder = new();

    public void Dispose()
    {
        _session.Dispose();
        _folder.Dispose();
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Cityscapes_has_stuff()
    {
        _folder.Export("cityscapes", _session.Open());
        (InstanceMap mask, InstanceMap classes) = Maps();
        const string frame = "out/gtFine/train/session0000/session0000_000000_000000_gtFine_";
        InstanceMap labels = PngDecoder.ReadLabelMap(_folder.PathOf(frame + "labelIds.png"));
        InstanceMap trained = PngDecoder.ReadLabelMap(_folder.PathOf(frame + "labelTrainIds.png"));
        Dictionary<SemanticClass, (int Label, int Trained)> expected = new()
        {
            [SemanticClass.Road] = (7, 0),
            [SemanticClass.LaneMarking] = (7, 0),
            [SemanticClass.Pavement] = (8, 1),
            [SemanticClass.Building] = (11, 2),
            [SemanticClass.Fence] = (13, 4),
            [SemanticClass.Pole] = (17, 5),
            [SemanticClass.Vegetation] = (21, 8),
            [SemanticClass.Terrain] = (22, 9),
            [SemanticClass.Sky] = (23, 10),
        };
        for (int i = 0; i < mask.Ids.Length; i++)
        {
            if (mask.Ids[i] == 0)
            {
                (int label, int train) = expected.GetValueOrDefault((SemanticClass)classes.Ids[i], (0, 255));
                Assert.Equal((label, train), (labels.Ids[i], trained.Ids[i]));
            }
        }

        AssertValid();
    }

    [Fact]
    public void Panoptic_has_stuff()
    {
        _folder.Export("coco-panoptic", _session.Open());
        (InstanceMap mask, InstanceMap classes) = Maps();
        JsonNode file = JsonNode.Parse(File.ReadAllText(_folder.PathOf("out/annotations/panoptic_train.json")))!;
        Dictionary<int, string> names = file["categories"]!
            .AsArray()
            .ToDictionary(item => item!["id"]!.GetValue<int>(), item => item!["name"]!.GetValue<string>());
        JsonNode annotation = file["annotations"]!.AsArray().First(item => item!["image_id"]!.GetValue<int>() == 0)!;
        Dictionary<int, string> segments = annotation["segments_info"]!
            .AsArray()
            .ToDictionary(item => item!["id"]!.GetValue<int>(), item => names[item!["category_id"]!.GetValue<int>()]);
        PixelBuffer picture = PngDecoder.ReadRgb(_folder.PathOf("out/annotations/panoptic_train/00000000.png"));
        for (int i = 0; i < mask.Ids.Length; i++)
        {
            int segment = picture.Bytes[i * 3] | (picture.Bytes[(i * 3) + 1] << 8) | (picture.Bytes[(i * 3) + 2] << 16);
            if (mask.Ids[i] == 0)
            {
                var kind = (SemanticClass)classes.Ids[i];
                string expected = kind is SemanticClass.None or >= SemanticClass.Car ? "void" : JsonNameOf(kind);
                Assert.Equal(expected, segment == 0 ? "void" : segments[segment]);
            }
        }

        Assert.Contains("road", segments.Values);
        Assert.DoesNotContain("background", names.Values);
        AssertValid();
    }

    [Fact]
    public void Semantic_has_maps_with_a_palette_and_the_drivable_area()
    {
        _folder.Export("semantic", _session.Open());
        (_, InstanceMap classes) = Maps();
        const string map = "out/classes/train/00000000.png";
        byte[] bytes = File.ReadAllBytes(_folder.PathOf(map));
        InstanceMap drivable = PngDecoder.ReadLabelMap(_folder.PathOf("out/drivable/train/00000000.png"));

        Assert.Equal(classes.Ids, PngDecoder.ReadLabelMap(_folder.PathOf(map)).Ids);
        Assert.Equal(3, bytes[25]);
        Assert.Equal("PLTE"u8.ToArray(), bytes[37..41]);
        Assert.Equal([128, 64, 128], bytes[44..47]);
        Assert.Equal(
            classes.Ids.Select(value => value is (ushort)SemanticClass.Road or (ushort)SemanticClass.LaneMarking ? 255 : 0),
            drivable.Ids.Select(value => (int)value)
        );
        AssertValid();
    }

    [Fact]
    public void Damaged_semantic_export_is_found()
    {
        _folder.Export("semantic", _session.Open());
        InstanceMap drivable = PngDecoder.ReadLabelMap(_folder.PathOf("out/drivable/train/00000000.png"));
        drivable.Ids[0] ^= 255;
        using (FileStream file = File.Create(_folder.PathOf("out/drivable/train/00000000.png")))
        {
            new PngEncoder().WriteGrey8(drivable, file);
        }

        File.Delete(_folder.PathOf("out/classes/train/00000001.png"));
        string[] problems = [.. DatasetValidator.Validate(_folder.PathOf("out")).Problems.Select(problem => problem.ToString())];

        Assert.Contains("drivable/train/00000000.png: it is not the road and its markings in the class map.", problems);
        Assert.Contains("classes/train/00000001.png: it is missing, but its image exists.", problems);
    }

    [Fact]
    public void Webdataset_takes_class_maps_along()
    {
        _folder.Export("webdataset", _session.Open());

        AssertValid();
    }

    private static string JsonNameOf(SemanticClass kind) => Harvester.Sessions.Text.JsonName.Of(kind);

    private void AssertValid() => Assert.Empty(DatasetValidator.Validate(_folder.PathOf("out")).Problems);

    private (InstanceMap Mask, InstanceMap Classes) Maps()
    {
        FrameLabel label = _session.Open().ReadLabels().First();
        return (PngDecoder.ReadInstanceMap(_session.PathOf(label.Mask!)), PngDecoder.ReadLabelMap(_session.PathOf(label.ClassMap!.File)));
    }
}
