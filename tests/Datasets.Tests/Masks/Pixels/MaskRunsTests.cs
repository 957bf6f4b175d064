using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Masks.Pixels;

public sealed class MaskRunsTests
{
    [Fact]
    public void Encode_runs_down_the_columns()
    {
        // Columns of a 3 x 2 image: (0, 1), (1, 1), (0, 0): 1 outside, 3 inside, 2 outside.
        var map = new InstanceMap(new ImageSize(3, 2));
        map[0, 1] = map[1, 0] = map[1, 1] = 5;

        Assert.Equal([1, 3, 2], Encode(map, 5));
        Assert.Equal([6], Encode(map, 4));
        map[0, 0] = 5;
        Assert.Equal([0, 4, 2], Encode(map, 5));
    }

    [Fact]
    public void Decode_inverts_Encode() =>
        RandomCases.Check(
            50,
            MaskOutlinesTests.Pixels,
            pixels =>
            {
                InstanceMap map = MaskOutlinesTests.MapOf(pixels);

                PixelMap back = MaskRuns.Decode(Encode(map, 1), map.Image);

                for (int pixel = 0; pixel < map.Image.PixelCount; pixel++)
                {
                    Assert.Equal(map.Ids[pixel] == 1, back[pixel % map.Image.Width, pixel / map.Image.Width]);
                }
            }
        );

    [Fact]
    public void Decode_counts_that_do_not_add_up_are_refused()
    {
        var size = new ImageSize(3, 2);
        Assert.Throws<ArgumentException>(() => MaskRuns.Decode([1, 3], size));
        Assert.Throws<ArgumentException>(() => MaskRuns.Decode([1, 6], size));
        Assert.Throws<ArgumentException>(() => MaskRuns.Decode([7, -1], size));
    }

    private static IReadOnlyList<int> Encode(InstanceMap map, ushort number) =>
        InstancePixels.AllOf(map).TryGetValue(number, out InstancePixels? pixels) ? MaskRuns.Encode(pixels) : [map.Image.PixelCount];
}
