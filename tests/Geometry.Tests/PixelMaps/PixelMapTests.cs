using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.Tests.PixelMaps;

public sealed class PixelMapTests
{
    private static readonly ImageSize Size = new(7, 5);

    [Fact]
    public void Or_is_the_union_of_both_maps()
    {
        var random = new Random(1);
        PixelMap a = Draw(random);
        PixelMap b = Draw(random);

        PixelMap either = a.Or(b);

        int count = 0;
        for (int row = 0; row < Size.Height; row++)
        {
            for (int column = 0; column < Size.Width; column++)
            {
                Assert.Equal(a[column, row] || b[column, row], either[column, row]);
                count += either[column, row] ? 1 : 0;
            }
        }

        Assert.Equal(count, either.Count);
        Assert.True(either.Count > a.Count);
    }

    [Fact]
    public void Count_follows_set_and_cleared_pixels()
    {
        var map = new PixelMap(Size);
        map[3, 2] = true;
        map[3, 2] = true;
        map[6, 4] = true;
        Assert.Equal(2, map.Count);
        map[3, 2] = false;
        map[0, 0] = false;
        Assert.Equal(1, map.Count);
    }

    [Fact]
    public void PixelMap_outside_the_image_or_of_another_size_is_refused()
    {
        var map = new PixelMap(Size);
        Assert.Throws<ArgumentOutOfRangeException>(() => map[7, 0]);
        Assert.Throws<ArgumentOutOfRangeException>(() => map[0, -1] = true);
        Assert.Throws<ArgumentException>(() => map.Or(new PixelMap(new ImageSize(5, 7))));
        Assert.Throws<ArgumentNullException>(() => map.Or(null!));
    }

    private static PixelMap Draw(Random random)
    {
        var map = new PixelMap(Size);
        for (int i = 0; i < 12; i++)
        {
            map[random.Next(Size.Width), random.Next(Size.Height)] = true;
        }

        return map;
    }
}
