using FsCheck;
using Harvester.Datasets.Masks.Pixels;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Masks.Pixels;

public sealed class MaskOutlinesTests
{
    private static readonly ImageSize Size = new(9, 7);

    /// <summary>The pixels of maps that mix the world and two objects.</summary>
    internal static Arbitrary<int[]> Pixels => RandomCases.ArrayOf(RandomCases.Integer(0, 2), Size.PixelCount);

    internal static InstanceMap MapOf(int[] pixels)
    {
        var map = new InstanceMap(Size);
        for (int i = 0; i < pixels.Length; i++)
        {
            map.Ids[i] = (ushort)pixels[i];
        }

        return map;
    }

    [Fact]
    public void Outline_of_a_block_of_pixels_is_a_rectangle()
    {
        var map = new InstanceMap(new ImageSize(6, 5));
        map[2, 1] = map[3, 1] = map[4, 1] = map[2, 2] = map[3, 2] = map[4, 2] = 7;

        IReadOnlyList<Vector2D> outline = Assert.Single(MaskOutlines.Of(map, 7));

        Assert.Equal([new(5, 1), new(5, 3), new(2, 3), new(2, 1)], outline);
        Assert.Empty(MaskOutlines.Of(map, 6));
    }

    [Fact]
    public void Outline_of_a_ring_has_a_hole_of_opposite_winding()
    {
        var map = new InstanceMap(new ImageSize(3, 3));
        Array.Fill(map.Ids, (ushort)1);
        map[1, 1] = 0;

        IReadOnlyList<IReadOnlyList<Vector2D>> outlines = MaskOutlines.Of(map, 1);

        Assert.Equal([9.0, -1.0], outlines.Select(SignedArea));
    }

    [Fact]
    public void Pixels_that_touch_at_a_corner_have_separate_outlines()
    {
        var map = new InstanceMap(new ImageSize(2, 2));
        map[0, 0] = map[1, 1] = 1;

        Assert.Equal([1.0, 1.0], MaskOutlines.Of(map, 1).Select(SignedArea));
    }

    [Fact]
    public void Outlines_of_random_masks_enclose_the_area_of_their_pixels() =>
        RandomCases.Check(
            200,
            Pixels,
            pixels =>
            {
                InstanceMap map = MapOf(pixels);

                Assert.Equal(map.MapOf(1).Count, MaskOutlines.Of(map, 1).Sum(SignedArea), 1e-9);
            }
        );

    // Clockwise on the screen, where y points down, is positive.
    private static double SignedArea(IReadOnlyList<Vector2D> polygon) =>
        polygon.Select((corner, i) => corner.Cross(polygon[(i + 1) % polygon.Count])).Sum() / 2;
}
