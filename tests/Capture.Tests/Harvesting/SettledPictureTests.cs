using Harvester.Capture.Harvesting;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class SettledPictureTests
{
    private const int MaxLag = 4;
    private const int TimeLimit = 240;

    /// <summary>Levels by which a sky may still differ when it counts as settled: eight ticks change it by less than a tenth.</summary>
    private const double Remainder = 0.25;

    private static readonly ImageSize Size = new(160, 120);

    [Fact]
    public void Sudden_change_settles_after_the_still_ticks()
    {
        Assert.Equal(SettledPicture.StillTicks + 1, SettledAt(_ => 150, noise: 0));
    }

    [Theory]
    [InlineData(30)]
    [InlineData(100)]
    [InlineData(200)]
    public void Slow_fade_settles_only_when_it_has_ended(int fadeTicks)
    {
        int settled = SettledAt(tick => 100 + (80 * Math.Min(1.0, (double)tick / fadeTicks)), noise: 0)!.Value;

        Assert.InRange(settled, fadeTicks, fadeTicks + SettledPicture.StillTicks + 1);
    }

    [Fact]
    public void Fade_that_slows_down_settles_close_to_its_end()
    {
        double At(double tick) => 180 - (80 * Math.Exp(-tick / 15));
        int settled = SettledAt(tick => At(tick), noise: 0)!.Value;

        Assert.InRange(180 - At(settled), 0, Remainder);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(20)]
    public void Noise_alone_settles(int noise)
    {
        int settled = SettledAt(_ => 150, noise)!.Value;

        Assert.InRange(settled, SettledPicture.StillTicks + 1, SettledPicture.OnsetTicks + MaxLag + 10);
    }

    [Theory]
    [InlineData(5)]
    [InlineData(20)]
    public void Fade_under_noise_settles_only_near_its_end(int noise)
    {
        const int fadeTicks = 60;
        int settled = SettledAt(tick => 100 + (80 * Math.Min(1.0, (double)tick / fadeTicks)), noise)!.Value;

        // Two ticks before the end, 2.7 of the 80 levels are left.
        Assert.InRange(settled, fadeTicks - 2, fadeTicks + (2 * SettledPicture.StillTicks));
    }

    [Fact]
    public void Change_that_begins_late_is_waited_for()
    {
        int settled = SettledAt(tick => tick < 18 ? 100 : 100 + Math.Min(60, 3 * (tick - 18)), noise: 0)!.Value;

        Assert.InRange(settled, 18 + 20, 18 + 20 + SettledPicture.StillTicks + 1);
    }

    [Fact]
    public void Picture_that_stays_the_same_settles_after_the_onset()
    {
        Assert.Equal(SettledPicture.OnsetTicks + MaxLag, SettledAt(_ => 100, noise: 0));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Picture_that_keeps_changing_never_settles()
    {
        Assert.Null(SettledAt(tick => 140 + (30 * Math.Sin(tick * 2 * Math.PI / 40)), noise: 3));
    }

    [Fact]
    public void Change_in_a_small_part_is_noticed()
    {
        var detector = new SettledPicture(MaxLag);
        detector.Begin();
        detector.Observe(Picture(100, 0, 0));
        detector.Begin();
        int settled = 1;
        while (!detector.Observe(WithPatch(Picture(100, 0, 0), (byte)(100 + Math.Min(50, settled)))))
        {
            settled++;
        }

        Assert.InRange(settled, 50, 50 + SettledPicture.StillTicks + 1);
    }

    /// <summary>The tick at which a change from a picture of level 100 has settled; null if it does not in time.</summary>
    private static int? SettledAt(Func<int, double> level, int noise)
    {
        var detector = new SettledPicture(MaxLag);
        detector.Begin();
        detector.Observe(Picture(100, noise, 0));
        detector.Begin();
        for (int tick = 1; tick <= TimeLimit; tick++)
        {
            if (detector.Observe(Picture(level(tick), noise, tick)))
            {
                return tick;
            }
        }

        return null;
    }

    /// <summary>A picture of one level, with as many pixels rounded up as its fraction says, and equally distributed noise.</summary>
    private static PixelBuffer Picture(double level, int noise, int seed)
    {
        var random = new Random(seed);
        var picture = new PixelBuffer(Size);
        for (int i = 0; i < picture.Bytes.Length; i++)
        {
            double rounding = (i * 0.618033988749895) % 1;
            double value = Math.Floor(level + rounding) + (noise == 0 ? 0 : random.Next(-noise, noise + 1));
            picture.Bytes[i] = (byte)Math.Clamp(value, 0, 255);
        }

        return picture;
    }

    /// <summary>Paints six by six pixels.</summary>
    private static PixelBuffer WithPatch(PixelBuffer picture, byte level)
    {
        for (int row = 42; row < 48; row++)
        {
            Array.Fill(picture.Bytes, level, ((row * Size.Width) + 71) * 3, 6 * 3);
        }

        return picture;
    }
}
