using Harvester.Geometry.Paint;

namespace Harvester.Geometry.Tests.Paint;

/// <summary>Stripes in profiles that are drawn at known places.</summary>
public sealed class StripeFinderTests
{
    private const double Asphalt = 80;
    private const double White = 200;

    [Theory]
    [InlineData(3.0, 0.10)]
    [InlineData(3.013, 0.15)]
    [InlineData(2.987, 0.30)]
    public void Stripe_is_found_to_half_a_centimetre(double middle, double width)
    {
        (double found, double foundWidth) = Assert.Single(Find((middle - (width / 2), middle + (width / 2), White)));

        Assert.InRange(found, middle - 0.005, middle + 0.005);
        Assert.InRange(foundWidth, width - 0.02, width + 0.02);
    }

    [Fact]
    public void Both_stripes_of_a_double_line_are_found()
    {
        List<(double Middle, double Width)> found = Find((2.8, 2.9, White), (3.0, 3.1, White));

        Assert.Equal(2, found.Count);
        Assert.InRange(found[0].Middle, 2.84, 2.86);
        Assert.InRange(found[1].Middle, 3.04, 3.06);
    }

    [Fact]
    public void Border_of_a_bright_pavement_is_no_stripe() => Assert.Empty(Find((3, 6, White)));

    [Fact]
    public void Crack_is_no_stripe() => Assert.Empty(Find((3, 3.1, 30)));

    [Fact]
    public void Bar_of_a_crossing_is_no_stripe() => Assert.Empty(Find((3, 3.5, White)));

    [Fact]
    public void Faint_seam_is_no_stripe() => Assert.Empty(Find((3, 3.15, 1.15 * Asphalt)));

    [Fact]
    public void Stripe_beside_a_kerb_is_found()
    {
        (double found, _) = Assert.Single(Find((3, 3.15, White), (3.5, 6, 150)));

        Assert.InRange(found, 3.065, 3.085);
    }

    /// <summary>A profile 6 m wide of asphalt with parts of other brightness, each cell the mean over its width.</summary>
    private static List<(double Middle, double Width)> Find(params (double From, double To, double Brightness)[] parts)
    {
        int cells = (int)(6 / StripeFinder.Cell);
        float[] profile = new float[cells];
        for (int i = 0; i < cells; i++)
        {
            double from = i * StripeFinder.Cell;
            double value = Asphalt;
            foreach ((double begin, double end, double brightness) in parts)
            {
                double covered = Math.Max(0, Math.Min(end, from + StripeFinder.Cell) - Math.Max(begin, from)) / StripeFinder.Cell;
                value += covered * (brightness - Asphalt);
            }

            profile[i] = (float)value;
        }

        var stripes = new List<StripeFinder.Stripe>();
        StripeFinder.OfLines().Find(profile, profile, 0, cells, stripes);
        return stripes.ConvertAll(stripe =>
            ((stripe.Left + stripe.Right) / 2 * StripeFinder.Cell, (stripe.Right - stripe.Left) * StripeFinder.Cell)
        );
    }
}
