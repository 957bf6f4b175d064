using Harvester.Exports.Formats.Kitti;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Tests.Kitti;

public sealed class SemanticKittiLabelTests
{
    [Theory]
    [InlineData(SemanticClass.Sky, 0, 0)]
    [InlineData(SemanticClass.Car, 3, 10 + (3 << 16))]
    [InlineData(SemanticClass.TrafficLight, 0, 99)]
    [InlineData(SemanticClass.Car, 4, 252 + (4 << 16))]
    [InlineData(SemanticClass.Bus, 4, 257 + (4 << 16))]
    [InlineData(SemanticClass.Road, 4, 40 + (4 << 16))]
    [InlineData(SemanticClass.Rider, 15, 253 + (14 << 16))]
    [InlineData(SemanticClass.Bicycle, 14, 253 + (14 << 16))]
    [InlineData(SemanticClass.Rider, 7, 32 + (6 << 16))]
    [InlineData(SemanticClass.Motorcycle, 6, 32 + (6 << 16))]
    [InlineData(SemanticClass.Motorcycle, 8, 15 + (8 << 16))]
    [InlineData(SemanticClass.Rider, 9, 30 + (9 << 16))]
    public void Label_has_the_class_below_the_id(SemanticClass kind, int id, int label)
    {
        var riders = new Riders(
            new Dictionary<int, (int, ObjectClass)> { [15] = (14, ObjectClass.Bicycle), [7] = (6, ObjectClass.Motorcycle) }
        );
        using var stream = new MemoryStream();
        SemanticKittiLabels.Write(stream, [new LidarPoint(1, 2, 3, 0.5f, 0, 0, (ushort)id, kind)], new HashSet<int> { 4, 14, 15 }, riders);

        Assert.Equal(label, BitConverter.ToInt32(stream.ToArray()));
    }
}
