using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Sessions.Tests.Imaging;

public sealed class ImageScalerTests
{
    // Weights are rounded to 1/16384 and rows to 1/64; a value at 255 may be off by 255/16384 + 1/128 before the last rounding to 1/2.
    private const double RoundingTolerance = 0.53;

    [Fact]
    public void Scale_to_half_gives_the_mean_of_each_block()
    {
        // Red: (0 + 100 + 50 + 250) / 4 = 100. Green: (1 + 2 + 3 + 4) / 4 = 2.5, rounded to 3. Blue: 255.
        PixelBuffer source = Picture(2, 2, [0, 1, 255, 100, 2, 255, 50, 3, 255, 250, 4, 255]);

        Assert.Equal([100, 3, 255], Scale(source, 1, 1).Bytes);
    }

    [Fact]
    public void Scale_from_three_columns_to_two_weighs_by_covered_area()
    {
        // Each output column covers 1.5 source columns: (90 · 1 + 30 · 0.5) / 1.5 = 70 and (30 · 0.5 + 120 · 1) / 1.5 = 90.
        PixelBuffer source = Picture(3, 1, [90, 0, 0, 30, 0, 0, 120, 0, 0]);

        Assert.Equal([70, 0, 0, 90, 0, 0], Scale(source, 2, 1).Bytes);
    }

    [Fact]
    public void Scale_to_double_interpolates_between_pixel_centres()
    {
        // Output centres 0.5, 1.5, 2.5, 3.5 halved lie at -0.25, 0.25, 0.75, 1.25 of the source's centres: 0, 0.25 · 80, 0.75 · 80, 80.
        PixelBuffer source = Picture(2, 1, [0, 0, 0, 80, 0, 0]);

        Assert.Equal([0, 20, 60, 80], Scale(source, 4, 1).Bytes.Where((_, i) => i % 3 == 0));
    }

    [Fact]
    public void Scale_may_shrink_one_axis_and_enlarge_the_other()
    {
        PixelBuffer source = Picture(2, 1, [10, 0, 0, 30, 0, 0]);

        Assert.Equal([20, 20, 20], Scale(source, 1, 3).Bytes.Where((_, i) => i % 3 == 0));
    }

    [Fact]
    public void Scale_to_the_same_size_copies()
    {
        PixelBuffer source = Noise(7, 5, seed: 1);

        Assert.Equal(source.Bytes, Scale(source, 7, 5).Bytes);
    }

    [Theory]
    [InlineData(1920, 1080, 800, 600)]
    [InlineData(801, 603, 800, 600)]
    [InlineData(333, 251, 800, 600)]
    [InlineData(5000, 3, 7, 2)]
    [InlineData(3, 1000, 1000, 3)]
    [InlineData(1, 1, 64, 48)]
    public void Scale_of_a_uniform_picture_leaves_its_colour(int width, int height, int toWidth, int toHeight)
    {
        PixelBuffer source = Picture(width, height, Uniform(width * height));

        PixelBuffer target = Scale(source, toWidth, toHeight);

        Assert.Equal(Uniform(target.Size.PixelCount), target.Bytes);
    }

    [Theory]
    [InlineData(97, 61, 40, 30)]
    [InlineData(64, 48, 63, 47)]
    [InlineData(100, 10, 3, 10)]
    public void Scale_down_agrees_with_the_integral_over_each_output_pixel(int width, int height, int toWidth, int toHeight)
    {
        PixelBuffer source = Noise(width, height, seed: 2);

        PixelBuffer target = Scale(source, toWidth, toHeight);

        for (int y = 0, i = 0; y < toHeight; y++)
        {
            for (int x = 0; x < toWidth; x++)
            {
                for (int channel = 0; channel < 3; channel++, i++)
                {
                    Assert.Equal(
                        Integral(source, x, y, channel, (double)width / toWidth, (double)height / toHeight),
                        target.Bytes[i],
                        RoundingTolerance
                    );
                }
            }
        }
    }

    [Fact]
    public void Scale_keeps_the_position_of_an_edge()
    {
        // White from column 30 of 100 on: scaled to 40 columns the edge is at 30 · 40 / 100 = 12 exactly.
        PixelBuffer source = Picture(100, 1, [.. Enumerable.Range(0, 300).Select(i => (byte)(i / 3 < 30 ? 0 : 255))]);

        byte[] red = [.. Scale(source, 40, 1).Bytes.Where((_, i) => i % 3 == 0)];

        Assert.Equal([.. Enumerable.Repeat((byte)0, 12), .. Enumerable.Repeat((byte)255, 28)], red);
    }

    [Fact]
    public void Scale_of_another_size_is_refused()
    {
        var scaler = new ImageScaler(new ImageSize(4, 4), new ImageSize(2, 2));

        Assert.Throws<ArgumentException>(() => scaler.Scale(Noise(4, 5, 1), Noise(2, 2, 1)));
        Assert.Throws<ArgumentException>(() => scaler.Scale(Noise(4, 4, 1), Noise(2, 3, 1)));
    }

    private static byte[] Uniform(int pixels)
    {
        byte[] colour = [255, 128, 1];
        return [.. Enumerable.Range(0, 3 * pixels).Select(i => colour[i % 3])];
    }

    private static double Integral(PixelBuffer source, int x, int y, int channel, double stepX, double stepY)
    {
        double sum = 0;
        for (int row = 0; row < source.Size.Height; row++)
        {
            for (int column = 0; column < source.Size.Width; column++)
            {
                double coveredX = Math.Min((x + 1) * stepX, column + 1) - Math.Max(x * stepX, column);
                double coveredY = Math.Min((y + 1) * stepY, row + 1) - Math.Max(y * stepY, row);
                sum += Math.Max(0, coveredX) * Math.Max(0, coveredY) * source.Bytes[(((row * source.Size.Width) + column) * 3) + channel];
            }
        }

        return sum / (stepX * stepY);
    }

    private static PixelBuffer Scale(PixelBuffer source, int width, int height)
    {
        var target = new PixelBuffer(new ImageSize(width, height));
        new ImageScaler(source.Size, target.Size).Scale(source, target);
        return target;
    }

    private static PixelBuffer Noise(int width, int height, int seed)
    {
        var buffer = new PixelBuffer(new ImageSize(width, height));
        new Random(seed).NextBytes(buffer.Bytes);
        return buffer;
    }

    private static PixelBuffer Picture(int width, int height, byte[] bytes)
    {
        var buffer = new PixelBuffer(new ImageSize(width, height));
        bytes.CopyTo(buffer.Bytes, 0);
        return buffer;
    }
}
