using Harvester.Capture.Labels;
using Harvester.Capture.Scenes;
using Harvester.Datasets.Images;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Tests.Exports.Cityscapes;

[Collection(SimulatedSession.Collection)]
public sealed class CityscapesWriterTests(SimulatedSession simulated) : ExportTests
{
    [Fact]
    public void Instance_ids_are_a_thousand_times_the_label_and_a_number()
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
            foreach (IGrouping<int, (int Id, int Instance)> own in mask.Ids.Zip(instances.Ids, (id, instance) => (Id: (int)id, Instance: (int)instance)).GroupBy(pair => pair.Id))
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
                    ObjectClass.TrafficLight => 19,
                    ObjectClass.Sign => 20,
                    _ => 5,
                };
                Assert.Equal(expected, instance >= 1000 ? instance / 1000 : instance);
                Assert.Equal(expected >= 24, instance >= 1000);
            }

            int[] numbered = [.. instances.Ids.Where(id => id >= 1000).Select(id => (int)id).Distinct()];
            Assert.Equal(numbered.Length, mask.Ids.Zip(instances.Ids).Where(pair => pair.Second >= 1000).Select(pair => pair.First).Distinct().Count());
            frame++;
        }
    }
}
