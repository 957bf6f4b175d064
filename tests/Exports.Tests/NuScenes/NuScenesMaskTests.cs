using Harvester.Exports.Formats.NuScenes;
using Harvester.Geometry;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Reading.Images;

namespace Harvester.Exports.Tests.NuScenes;

public sealed class NuScenesMaskTests : IDisposable
{
    private readonly ExportFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Polygon_is_where_the_devkit_looks_for_it()
    {
        // A triangle of the world at (-5, 2), 3 m wide at its foot and 2 m high, on a map whose corner is (-6, 1).
        InstanceMap mask = Drawn(new NuScenesArea(-6, 1, -1, 5), [new(-5, 2), new(-2, 2), new(-5, 4)]);

        Assert.Equal((50, 40), (mask.Image.Width, mask.Image.Height));
        Assert.True(Has(mask, 1.1, 1.1) && Has(mask, 3.7, 1.1) && Has(mask, 1.1, 2.8));
        Assert.False(Has(mask, 0.9, 1.1) || Has(mask, 1.1, 0.8) || Has(mask, 3.7, 1.5) || Has(mask, 1.6, 2.8));
    }

    [Fact]
    public void Corner_that_points_inward_is_not_filled()
    {
        InstanceMap mask = Drawn(new NuScenesArea(0, 0, 4, 4), [new(0.5, 0.5), new(2, 2), new(3.5, 0.5), new(3.5, 3.5), new(0.5, 3.5)]);

        Assert.True(Has(mask, 2, 2.5) && Has(mask, 0.7, 1.5) && Has(mask, 3.3, 1.5));
        Assert.False(Has(mask, 2, 1.5));
    }

    [Fact]
    public void Ground_beyond_the_map_is_cut_off()
    {
        InstanceMap mask = Drawn(new NuScenesArea(0, 0, 2, 2), [new(-5, -5), new(9, -5), new(9, 9), new(-5, 9)]);

        Assert.All(mask.Ids, id => Assert.Equal(255, id));
    }

    [Fact]
    public void Map_larger_than_four_kilometres_is_a_black_pixel()
    {
        InstanceMap mask = Drawn(new NuScenesArea(0, 0, 4001, 10), [new(0, 0), new(9, 0), new(9, 9)]);

        Assert.Equal((1, 1, 0), (mask.Image.Width, mask.Image.Height, mask.Ids[0]));
    }

    /// <summary>The pixel of a position by the devkit's rule: x / 0.1, height - y / 0.1, rounded.</summary>
    private static bool Has(InstanceMap mask, double x, double y) =>
        mask.Ids[((mask.Image.Height - (int)Math.Round(y * 10)) * mask.Image.Width) + (int)Math.Round(x * 10)] == 255;

    private InstanceMap Drawn(NuScenesArea area, Vector2D[] polygon)
    {
        string path = _folder.PathOf("mask.png");
        using (FileStream file = File.Create(path))
        {
            new NuScenesMask(area, [polygon]).Write(file);
        }

        return PngDecoder.ReadLabelMap(path);
    }
}
