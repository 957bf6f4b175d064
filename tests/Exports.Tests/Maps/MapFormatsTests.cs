using Harvester.Exports.Maps;

namespace Harvester.Exports.Tests.Maps;

/// <summary>What all formats of maps have in common.</summary>
public sealed class MapFormatsTests
{
    public static TheoryData<string> Names => [.. MapFormats.All.Select(format => format.Name)];

    [Theory]
    [MemberData(nameof(Names))]
    public void Same_roads_give_the_same_bytes(string name)
    {
        byte[] first = Bytes(name);

        Assert.NotEmpty(first);
        Assert.Equal(first, Bytes(name));
        Assert.DoesNotContain((byte)'\r', first);
    }

    [Fact]
    public void Names_differ() => Assert.Equal(MapFormats.All.Count, MapFormats.All.Select(format => format.Name).Distinct().Count());

    private static byte[] Bytes(string name)
    {
        using var stream = new MemoryStream();
        MapFormats.All.Single(format => format.Name == name).Write(TownMap.Of(472), "town", stream);
        return stream.ToArray();
    }
}
