using System.Text.Json;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Images;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Cityscapes;

[Collection(SimulatedSession.Collection)]
public sealed class CityscapesWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Polygons_drawn_in_order_reproduce_the_label_map()
    {
        Folder.Export("cityscapes", simulated.Open());
        for (int frame = 0; frame < SimulatedSession.Frames; frame++)
        {
            string name = $"out/gtFine/train/session0000/session0000_000000_{frame:D6}_gtFine_";
            InstanceMap labels = PngDecoder.ReadLabelMap(Folder.PathOf(name + "labelIds.png"));
            using JsonDocument polygons = JsonDocument.Parse(File.ReadAllText(Folder.PathOf(name + "polygons.json")));
            var drawn = new InstanceMap(labels.Image);
            foreach (JsonElement item in polygons.RootElement.GetProperty("objects").EnumerateArray())
            {
                (int X, int Y)[] corners =
                [
                    .. item.GetProperty("polygon").EnumerateArray().Select(corner => (corner[0].GetInt32(), corner[1].GetInt32())),
                ];
                Draw(drawn, corners, LabelIds[item.GetProperty("label").GetString()!]);
            }

            Assert.Equal(labels.Ids, drawn.Ids);
        }
    }

    [Fact]
    public void Training_ids_are_those_of_the_benchmark()
    {
        Folder.Export("cityscapes", simulated.Open());
        const string name = "out/gtFine/train/session0000/session0000_000000_000000_gtFine_";
        InstanceMap labels = PngDecoder.ReadLabelMap(Folder.PathOf(name + "labelIds.png"));
        InstanceMap trainIds = PngDecoder.ReadLabelMap(Folder.PathOf(name + "labelTrainIds.png"));

        (int Label, int TrainId)[] pairs = [.. labels.Ids.Zip(trainIds.Ids, (label, trainId) => ((int)label, (int)trainId)).Distinct()];
        Assert.Contains((26, 13), pairs);
        Assert.All(
            pairs,
            pair =>
                Assert.Equal(
                    pair.Label switch
                    {
                        17 => 5,
                        19 => 6,
                        20 => 7,
                        24 => 11,
                        25 => 12,
                        26 => 13,
                        27 => 14,
                        28 => 15,
                        32 => 17,
                        33 => 18,
                        _ => 255,
                    },
                    pair.TrainId
                )
        );
    }

    private static readonly Dictionary<string, ushort> LabelIds = new()
    {
        ["unlabeled"] = 0,
        ["dynamic"] = 5,
        ["pole"] = 17,
        ["traffic light"] = 19,
        ["traffic sign"] = 20,
        ["person"] = 24,
        ["rider"] = 25,
        ["car"] = 26,
        ["truck"] = 27,
        ["bus"] = 28,
        ["trailer"] = 30,
        ["motorcycle"] = 32,
        ["bicycle"] = 33,
    };

    /// <summary>
    /// Draws a polygon of horizontal and vertical sides with its edges: the pixels on its sides, and those to whose left an odd number of
    /// sides passes.
    /// </summary>
    private static void Draw(InstanceMap map, (int X, int Y)[] corners, ushort value)
    {
        (int top, int bottom) = (corners.Min(corner => corner.Y), corners.Max(corner => corner.Y));
        var sides = corners.Select((corner, i) => (From: corner, To: corners[(i + 1) % corners.Length])).ToList();
        for (int y = top; y <= bottom; y++)
        {
            int[] crossings =
            [
                .. sides
                    .Where(side =>
                        side.From.X == side.To.X && Math.Min(side.From.Y, side.To.Y) <= y && y < Math.Max(side.From.Y, side.To.Y)
                    )
                    .Select(side => side.From.X)
                    .Order(),
            ];
            for (int i = 0; i + 1 < crossings.Length; i += 2)
            {
                Fill(y, crossings[i], crossings[i + 1]);
            }

            foreach (
                (var from, var to) in sides.Where(side => Math.Min(side.From.Y, side.To.Y) <= y && y <= Math.Max(side.From.Y, side.To.Y))
            )
            {
                Fill(y, Math.Min(from.X, to.X), Math.Max(from.X, to.X));
            }
        }

        void Fill(int row, int first, int last)
        {
            for (int column = first; column <= last; column++)
            {
                map[column, row] = value;
            }
        }
    }

    [Fact]
    public void Instance_ids_are_1000_times_the_label_plus_a_number()
    {
        Folder.Export("cityscapes", simulated.Open());
        int frame = 0;
        foreach (FrameLabel label in simulated.Open().ReadLabels())
        {
            InstanceMap mask = PngDecoder.ReadInstanceMap(simulated.Open().PathOf(label.Mask!));
            string name = $"out/gtFine/train/session0000/session0000_000000_{frame:D6}_gtFine_";
            InstanceMap instances = PngDecoder.ReadInstanceMap(Folder.PathOf(name + "instanceIds.png"));
            Assert.Equal(8, ImageHeader.Read(Folder.PathOf(name + "labelIds.png")).BitsPerPixel);
            Assert.True(File.Exists(Folder.PathOf($"out/leftImg8bit/train/session0000/session0000_000000_{frame:D6}_leftImg8bit.png")));
            // One object, one instance id, and the other way round, except for what has no instances.
            foreach (
                IGrouping<int, (int Id, int Instance)> own in mask
                    .Ids.Zip(instances.Ids, (id, instance) => (Id: (int)id, Instance: (int)instance))
                    .GroupBy(pair => pair.Id)
            )
            {
                int instance = Assert.Single(own.Select(pair => pair.Instance).Distinct());
                ObjectClass? kind = label.Objects.SingleOrDefault(item => item.Id == own.Key)?.Class;
                int expected = kind switch
                {
                    null => 0,
                    ObjectClass.Car => 26,
                    ObjectClass.Truck => 27,
                    ObjectClass.Bus => 28,
                    ObjectClass.Trailer => 30,
                    ObjectClass.Motorcycle => 32,
                    ObjectClass.Bicycle => 33,
                    ObjectClass.Pedestrian => 24,
                    ObjectClass.Rider => 25,
                    ObjectClass.TrafficLight => 19,
                    ObjectClass.Sign => 20,
                    _ => 5,
                };
                Assert.Equal(expected, instance >= 1000 ? instance / 1000 : instance);
                Assert.Equal(expected >= 24, instance >= 1000);
            }

            int[] numbered = [.. instances.Ids.Where(id => id >= 1000).Select(id => (int)id).Distinct()];
            Assert.Equal(
                numbered.Length,
                mask.Ids.Zip(instances.Ids).Where(pair => pair.Second >= 1000).Select(pair => pair.First).Distinct().Count()
            );
            frame++;
        }
    }
}
