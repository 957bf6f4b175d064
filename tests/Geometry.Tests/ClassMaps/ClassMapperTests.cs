using Harvester.Geometry.Cameras;
using Harvester.Geometry.ClassMaps;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.Tests.ClassMaps;

public sealed class ClassMapperTests
{
    private const byte Ground = 1;
    private const byte Sky = 2;
    private const byte Hill = 3;
    private const byte Pole = 4;
    private const byte Object = 9;
    private const int HorizonRow = 150;
    private static readonly ImageSize Image = new(400, 300);

    [Fact]
    public void A_scene_is_mapped_from_two_percent_of_its_pixels()
    {
        int budget = Image.PixelCount / 50;
        ClassMapper mapper = Run(new byte[Image.PixelCount], budget);
        InstanceMap map = mapper.Finish().Map;

        Assert.InRange(mapper.RaysCast, 1, budget);
        foreach ((byte value, double least) in new[] { (Ground, 0.99), (Sky, 0.99), (Hill, 0.98), (Pole, 0.8) })
        {
            int both = 0;
            int either = 0;
            for (int i = 0; i < map.Ids.Length; i++)
            {
                bool isThere = ClassAt(i % Image.Width, i / Image.Width) == value;
                both += isThere && map.Ids[i] == value ? 1 : 0;
                either += isThere || map.Ids[i] == value ? 1 : 0;
            }

            Assert.True(both >= least * either, $"class {value}: IoU {(double)both / either:F4}");
        }
    }

    [Fact]
    public void Given_pixels_are_neither_sampled_nor_changed()
    {
        byte[] given = new byte[Image.PixelCount];
        for (int row = 140; row < 200; row++)
        {
            given.AsSpan((row * Image.Width) + 100, 80).Fill(Object);
        }

        var mapper = new ClassMapper(
            Image,
            given,
            (column, row) =>
            {
                Assert.Equal(0, given[(row * Image.Width) + column]);
                return ClassAt(column, row);
            },
            HorizonRow,
            2_000
        );
        while (mapper.Step()) { }

        (InstanceMap map, int interpolated) = mapper.Finish();
        Assert.Equal(80 * 60, map.Ids.Count(value => value == Object));
        Assert.All(Enumerable.Range(0, given.Length).Where(i => given[i] != 0), i => Assert.Equal(Object, map.Ids[i]));
        Assert.Equal(Image.PixelCount - (80 * 60) - mapper.RaysCast, interpolated);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(37)]
    [InlineData(500)]
    public void Any_budget_gives_a_map_without_gaps(int budget)
    {
        ClassMapper mapper = Run(new byte[Image.PixelCount], budget);

        Assert.InRange(mapper.RaysCast, 1, budget);
        Assert.DoesNotContain((ushort)0, mapper.Finish().Map.Ids);
    }

    [Fact]
    public void Without_rays_there_is_only_what_is_given()
    {
        byte[] given = new byte[Image.PixelCount];
        given[5] = Object;
        ClassMapper mapper = Run(given, 0);

        Assert.Equal(0, mapper.RaysCast);
        Assert.Equal(Object, mapper.Finish().Map.Ids[5]);
    }

    [Fact]
    public void Each_pixel_is_sampled_once()
    {
        var seen = new HashSet<(int, int)>();
        var mapper = new ClassMapper(
            Image,
            new byte[Image.PixelCount],
            (column, row) =>
            {
                Assert.True(seen.Add((column, row)), $"{column}, {row} again");
                return ClassAt(column, row);
            },
            HorizonRow,
            4_000
        );
        while (mapper.Step()) { }

        Assert.Equal(seen.Count, mapper.RaysCast);
    }

    [Fact]
    public void Wrong_number_of_given_classes_is_refused() =>
        Assert.Throws<ArgumentException>(() => new ClassMapper(Image, new byte[3], ClassAt, HorizonRow, 10));

    private static ClassMapper Run(byte[] given, int budget)
    {
        var mapper = new ClassMapper(Image, given, ClassAt, HorizonRow, budget);
        while (mapper.Step()) { }

        return mapper;
    }

    /// <summary>Ground below a horizon, a round hill above it, and a pole of three pixels in front of both.</summary>
    private static byte ClassAt(int column, int row) =>
        column is >= 251 and <= 253 && row is >= 60 and < 190 ? Pole
        : row > HorizonRow + (column / 40) ? Ground
        : ((column - 120) * (column - 120)) + ((row - 150) * (row - 150)) < 70 * 70 ? Hill
        : Sky;
}
