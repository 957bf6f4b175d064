using Harvester.Capture.Calibration;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Tests.Calibration;

/// <summary>Discs of known centres over noise, drawn by counting the points of a pixel that they cover.</summary>
public sealed class MarkerDetectorTests
{
    private const int Width = 160;
    private const int Height = 120;
    private const double Radius = 6;
    private static readonly ImageSize Size = new(Width, Height);

    [Theory]
    [InlineData(8, 0.05)]
    [InlineData(1, 0.2)]
    public void Find_locates_the_centre_to_a_fraction_of_a_pixel(int samplesPerSide, double tolerance)
    {
        // With 64 points a pixel the picture is smooth; with 1 an outline of some 38 pixels is rounded: 0.3 · √38 / (6² π) = 0.02 px
        // typically.
        var random = new Random(1);
        for (int i = 0; i < 50; i++)
        {
            var centre = new Vector2D(Between(random, 20, Width - 20), Between(random, 20, Height - 20));
            PixelBuffer without = Noise(random);
            PixelBuffer with = Draw(without, centre, Radius, Radius, samplesPerSide);

            MarkerSpot spot = Assert.Single(MarkerDetector.Find(without, with, Radius));

            Assert.InRange((spot.Centre - centre).Length, 0, tolerance);
            Assert.InRange(spot.Area / (Math.PI * Radius * Radius), 0.95, 1.05);
        }
    }

    [Fact]
    public void Find_is_not_biased_by_a_two_tone_background()
    {
        PixelBuffer without = Uniform(10, 10, 10);
        for (int pixel = 0; pixel < Size.PixelCount; pixel++)
        {
            if (pixel % Width >= 80)
            {
                without.Bytes.AsSpan(pixel * 3, 3).Fill(240);
            }
        }

        var centre = new Vector2D(80.3, 60.7);

        MarkerSpot spot = Assert.Single(MarkerDetector.Find(without, Draw(without, centre, Radius, Radius, 8), Radius));

        Assert.InRange((spot.Centre - centre).Length, 0, 0.05);
    }

    [Fact]
    public void Find_detects_several_markers_and_ellipses()
    {
        PixelBuffer without = Noise(new Random(2));
        PixelBuffer with = Draw(without, new Vector2D(30, 30), 6, 6, 8);
        with = Draw(with, new Vector2D(100, 40), 6, 2.8, 8);
        with = Draw(with, new Vector2D(60.5, 90.25), 7, 7, 8);

        IReadOnlyList<MarkerSpot> spots = MarkerDetector.Find(without, with, Radius);

        Assert.Equal([30, 100, 60.5], spots.Select(spot => Math.Round(spot.Centre.X * 4) / 4));
    }

    [Theory]
    [InlineData(5, 60, 6)]
    [InlineData(80, 116, 6)]
    [InlineData(80, 60, 2)]
    [InlineData(80, 60, 12)]
    public void Find_omits_spots_that_are_cropped_or_of_another_size(double x, double y, double radius)
    {
        PixelBuffer without = Noise(new Random(3));

        Assert.Empty(MarkerDetector.Find(without, Draw(without, new Vector2D(x, y), radius, radius, 8), Radius));
    }

    [Fact]
    public void Find_is_robust_to_noise_that_differs_between_pictures()
    {
        // 25 grey levels between the noises at most, below the smallest change that counts.
        PixelBuffer without = Noise(new Random(4));
        var centre = new Vector2D(77.2, 51.9);
        PixelBuffer with = Draw(Noise(new Random(5)), centre, Radius, Radius, 8);

        MarkerSpot spot = Assert.Single(MarkerDetector.Find(without, with, Radius));

        Assert.InRange((spot.Centre - centre).Length, 0, 0.2);
    }

    [Fact]
    public void Find_between_equal_pictures_finds_nothing()
    {
        PixelBuffer picture = Noise(new Random(6));

        Assert.Empty(MarkerDetector.Find(picture, picture, Radius));
    }

    [Fact]
    public void Find_between_pictures_of_different_sizes_is_refused() =>
        Assert.Throws<ArgumentException>(() => MarkerDetector.Find(new PixelBuffer(Size), new PixelBuffer(new ImageSize(10, 10)), Radius));

    private static PixelBuffer Draw(PixelBuffer background, Vector2D centre, double radiusX, double radiusY, int samplesPerSide)
    {
        var picture = new PixelBuffer(Size);
        background.Bytes.CopyTo(picture.Bytes, 0);
        for (int y = 0; y < Height; y++)
        {
            for (int x = 0; x < Width; x++)
            {
                double covered = Covered(x, y, centre, radiusX, radiusY, samplesPerSide);
                for (int channel = 0; channel < 3; channel++)
                {
                    int i = (((y * Width) + x) * 3) + channel;
                    picture.Bytes[i] = (byte)Math.Round(picture.Bytes[i] + (covered * ((channel == 1 ? 0 : 255) - picture.Bytes[i])));
                }
            }
        }

        return picture;
    }

    private static double Covered(int x, int y, Vector2D centre, double radiusX, double radiusY, int samplesPerSide)
    {
        int inside = 0;
        for (int i = 0; i < samplesPerSide * samplesPerSide; i++)
        {
            double dx = (x + (((i % samplesPerSide) + 0.5) / samplesPerSide) - centre.X) / radiusX;
            double dy = (y + (((i / samplesPerSide) + 0.5) / samplesPerSide) - centre.Y) / radiusY;
            inside += (dx * dx) + (dy * dy) < 1 ? 1 : 0;
        }

        return inside / (double)(samplesPerSide * samplesPerSide);
    }

    private static double Between(Random random, double low, double high) => low + ((high - low) * random.NextDouble());

    private static PixelBuffer Noise(Random random)
    {
        PixelBuffer picture = Uniform(0, 0, 0);
        for (int i = 0; i < picture.Bytes.Length; i++)
        {
            picture.Bytes[i] = (byte)random.Next(90, 116);
        }

        return picture;
    }

    private static PixelBuffer Uniform(byte red, byte green, byte blue)
    {
        var picture = new PixelBuffer(Size);
        for (int i = 0; i < picture.Bytes.Length; i += 3)
        {
            picture.Bytes[i] = red;
            picture.Bytes[i + 1] = green;
            picture.Bytes[i + 2] = blue;
        }

        return picture;
    }
}
