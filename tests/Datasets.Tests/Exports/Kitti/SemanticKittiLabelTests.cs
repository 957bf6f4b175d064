using Harvester.Datasets.Exports.Formats.Kitti;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Semantics;

namespace Harvester.Datasets.Tests.Exports.Kitti;

public sealed class SemanticKittiLabelTests
{
    [Theory]
    [InlineData(SemanticClass.Sky, 0, 0)]
    [InlineData(SemanticClass.Car, 3, 10 + (3 << 16))]
    [InlineData(SemanticClass.TrafficLight, 0, 99)]
    [InlineData(SemanticClass.Car, 4, 252 + (4 << 16))]
    [InlineData(SemanticClass.Bus, 4, 257 + (4 << 16))]
    [InlineData(SemanticClass.Road, 4, 40 + (4 << 16))]
    public void Label_has_the_class_below_the_id(SemanticClass kind, int id, int label)
    {
        using var stream = new MemoryStream();
        SemanticKittiLabels.Write(stream, [new LidarPoint(1, 2, 3, 0.5f, 0, 0, (ushort)id, kind)], new HashSet<int> { 4 });

        Assert.Equal(label, BitConverter.ToInt32(stream.ToArray()));
    }
}
