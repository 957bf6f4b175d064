using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.Tests.PixelMaps;

public sealed class ScatteredRankTests
{
    [Fact]
    public void First_pixels_hit_every_aligned_rectangle_of_their_area_once()
    {
        const int side = 128;
        var rank = new ScatteredRank(new ImageSize(side, side));
        for (int k = 0; k <= 7; k++)
        {
            for (int width = 1; width <= 1 << k; width *= 2)
            {
                int height = (1 << k) / width;
                int[] counts = new int[side * side >> k];
                for (int row = 0; row < side; row++)
                {
                    for (int column = 0; column < side; column++)
                    {
                        counts[(row / height * (side / width)) + (column / width)] += rank.Of(column, row) < 1.0 / (1 << k) ? 1 : 0;
                    }
                }

                Assert.All(counts, count => Assert.Equal(1, count));
            }
        }
    }

    [Fact]
    public void Slanted_lines_are_hit_at_least_as_often_as_by_chance()
    {
        // 1 in 16 pixels: a line of 64 pixels is hit 4 times on average, and missed by chance in exp(-4) = 2 % of cases.
        const int length = 64;
        var rank = new ScatteredRank(new ImageSize(1024, 1024));
        foreach (
            (double right, double down) in new[]
            {
                (1.0, 1.0),
                (1.0, -1.0),
                (1.0, 0.5),
                (1.0, -0.5),
                (0.5, 1.0),
                (-0.5, 1.0),
                (1.0, 0.1),
                (0.1, 1.0),
            }
        )
        {
            int missed = 0;
            var random = new Random(1);
            for (int line = 0; line < 2000; line++)
            {
                int column = random.Next(length, 1024 - length);
                int row = random.Next(length, 1024 - length);
                missed += Enumerable.Range(0, length).Any(i => rank.Of((int)(column + (i * right)), (int)(row + (i * down))) < 1.0 / 16)
                    ? 0
                    : 1;
            }

            Assert.True(missed < 80, $"{right}, {down}: {missed} of 2000 missed");
        }
    }
}
