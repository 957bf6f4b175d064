using System.Runtime.Intrinsics;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

public sealed class ShadowRasteriserTests
{
    private const int Size = 128;
    private const int Triangles = 60;

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Heights_do_not_depend_on_the_tiles_drawn(int seed)
    {
        var random = new Random(seed);
        var all = new ShadowTiles(Size);
        all.AddAll();
        var some = new ShadowTiles(Size);
        for (int i = 0; i < 40; i++)
        {
            some.AddAround((random.Next(Size - 1) * Size) + random.Next(Size - 1));
        }

        float[] whole = Empty();
        float[] partly = Empty();
        for (int i = 0; i < Triangles; i++)
        {
            Vector256<double> a = Corner(random);
            Vector256<double> b = Corner(random);
            Vector256<double> c = Corner(random);
            ShadowRasteriser.Draw(a, b, c, whole, Size, all);
            ShadowRasteriser.Draw(a, b, c, partly, Size, some);
        }

        int drawn = 0;
        for (int texel = 0; texel < whole.Length; texel++)
        {
            int column = texel % Size;
            bool isIn = (some.ColumnsAt(texel / Size) & some.ColumnsOf(column, column + 1)) != 0;
            Assert.Equal(isIn ? whole[texel] : float.NegativeInfinity, partly[texel]);
            drawn += isIn && !float.IsNegativeInfinity(whole[texel]) ? 1 : 0;
        }

        Assert.InRange(drawn, 100, whole.Length / 2);
    }

    [Fact]
    public void Tiles_around_a_texel_are_those_of_four_texels()
    {
        // Tiles of 128 / 64 = 2 texels: texel (3, 5) is in tile (1, 2), its neighbours (4, 5), (3, 6) and (4, 6) are in other ones.
        var tiles = new ShadowTiles(Size);
        tiles.AddAround((5 * Size) + 3);

        Assert.Equal(0b110UL, tiles.ColumnsAt(4));
        Assert.Equal(0b110UL, tiles.ColumnsAt(6));
        Assert.Equal((0UL, 0UL), (tiles.ColumnsAt(3), tiles.ColumnsAt(8)));
        Assert.True(tiles.HasAnyIn(5, 7, 6, 8));
        Assert.False(tiles.HasAnyIn(6, 0, Size, Size));
    }

    [Fact]
    public void Stretches_end_at_missing_tiles_and_at_the_map()
    {
        var tiles = new ShadowTiles(Size);
        ulong columns = 0b110UL | (1UL << 63);

        Assert.Equal((2, 6), tiles.TakeStretch(ref columns));
        Assert.Equal((126, 128), tiles.TakeStretch(ref columns));
        Assert.Equal(0UL, columns);
    }

    private static float[] Empty()
    {
        var heights = new float[Size * Size];
        Array.Fill(heights, float.NegativeInfinity);
        return heights;
    }

    /// <summary>Some corners lie outside the map.</summary>
    private static Vector256<double> Corner(Random random) =>
        Vector256.Create(
            (random.NextDouble() * 1.4 * Size) - (0.2 * Size),
            (random.NextDouble() * 1.4 * Size) - (0.2 * Size),
            random.NextDouble() * 30,
            1
        );
}
