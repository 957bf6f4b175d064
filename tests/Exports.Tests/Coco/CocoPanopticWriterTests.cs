using System.Text.Json;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Coco;

[Collection(SimulatedSession.Collection)]
public sealed class CocoPanopticWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Colours_are_the_segments_of_the_masks()
    {
        Folder.Export("coco-panoptic", simulated.Open());
        using JsonDocument coco = JsonDocument.Parse(File.ReadAllText(Folder.PathOf("out/annotations/panoptic_train.json")));
        JsonElement[] annotations = [.. coco.RootElement.GetProperty("annotations").EnumerateArray()];
        FrameLabel[] labels = [.. simulated.Open().ReadLabels()];
        Assert.Equal(labels.Length, annotations.Length);
        foreach ((JsonElement annotation, FrameLabel label) in annotations.Zip(labels))
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(simulated.Open().PathOf(label.Mask!));
            PixelBuffer colours = PngDecoder.ReadRgb(
                Folder.PathOf("out/annotations/panoptic_train/" + annotation.GetProperty("file_name").GetString())
            );
            // The format's rgb2id: red + 256 green + 65536 blue.
            int[] ids = [.. colours.Bytes.Chunk(3).Select(rgb => rgb[0] + (256 * rgb[1]) + (65536 * rgb[2]))];
            // What is no object is the background, segment 2 · 65536.
            Assert.Equal(mask.Ids.Select(id => id == 0 ? 131072 : id), ids);
            Dictionary<int, int> areas = ids.Where(id => id != 0)
                .GroupBy(id => id)
                .ToDictionary(group => group.Key, group => group.Count());
            JsonElement[] segments = [.. annotation.GetProperty("segments_info").EnumerateArray()];
            Assert.Equal(areas.Keys.Order(), segments.Select(segment => segment.GetProperty("id").GetInt32()));
            Assert.All(
                segments,
                segment => Assert.Equal(areas[segment.GetProperty("id").GetInt32()], segment.GetProperty("area").GetInt32())
            );
        }
    }
}
