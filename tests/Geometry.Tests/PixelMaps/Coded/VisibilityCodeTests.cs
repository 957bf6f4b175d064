using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Geometry.Tests.PixelMaps.Coded;

public sealed class VisibilityCodeTests
{
    private static readonly Camera Camera = new(
        new Pose(new Vector3D(0, 0, 1.5), Axes.Identity),
        new CameraIntrinsics(50, new ImageSize(320, 240), 4.0 / 3, 0.15, Lens.Ideal)
    );

    [Theory]
    [InlineData(1, 3, 9)]
    [InlineData(7, 5, 13)]
    [InlineData(31, 7, 17)]
    [InlineData(127, 7, 17)]
    [InlineData(128, 8, 19)]
    public void Number_of_pictures_grows_with_the_logarithm(int objects, int bits, int pictures)
    {
        VisibilityCode code = VisibilityCode.For(Camera, Row(objects));

        Assert.Equal(bits, code.Bits);
        Assert.Equal(pictures, code.PictureCount);
        Assert.Equal(objects, Enumerable.Range(0, objects).Select(code.WordOf).Distinct().Count());
    }

    [Fact]
    public void Each_pair_of_pictures_of_a_bit_shows_every_object_once()
    {
        VisibilityCode code = VisibilityCode.For(Camera, Row(20));
        for (int target = 0; target < 20; target++)
        {
            Assert.True(code.IsShown(0, target));
            Assert.False(code.IsShown(code.NonePicture, target));
            Assert.True(code.IsShown(code.PictureCount - 1, target));
            for (int bit = 0; bit < code.Bits; bit++)
            {
                Assert.NotEqual(code.IsShown((2 * bit) + 1, target), code.IsShown((2 * bit) + 2, target));
            }
        }
    }

    [Fact]
    public void Pictures_show_each_of_two_neighbours_alone_and_neither()
    {
        MapTarget[] targets = Row(40);
        VisibilityCode code = VisibilityCode.For(Camera, targets);
        for (int i = 1; i < targets.Length; i++)
        {
            int first = i - 1;
            int second = i;
            var seen = Enumerable
                .Range(0, code.PictureCount - 2)
                .Select(picture => (code.IsShown(picture, first), code.IsShown(picture, second)))
                .Distinct();
            Assert.Equal(4, seen.Append((false, false)).Distinct().Count());
        }
    }

    /// <summary>Objects one behind another, so that the boxes of neighbours overlap.</summary>
    private static MapTarget[] Row(int count) =>
        [
            .. Enumerable
                .Range(0, count)
                .Select(number =>
                {
                    var cuboid = new Cuboid(new Vector3D((number % 9) - 4, 20 + number, 0.75), new Vector3D(0.9, 2, 0.75), Axes.Identity);
                    return new MapTarget(number + 100, (ushort)(number + 1), cuboid, CuboidProjector.Project(Camera, cuboid));
                }),
        ];
}
