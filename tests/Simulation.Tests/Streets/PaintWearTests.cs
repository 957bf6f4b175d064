using Harvester.Geometry;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Tests.Streets;

public sealed class PaintWearTests
{
    private const double Start = 0.1;
    private const double Length = 2000;

    /// <summary>Four cells, of which each is gone with a probability of at most one half, metres.</summary>
    private const double MaxFirstGap = 1;

    /// <summary>Four standard deviations of the share of 8000 cells that are left, at most 0.5 each.</summary>
    private const double ShareTolerance = 0.0224;

    [Theory]
    [InlineData(0.3, 0.85)]
    [InlineData(1, 0.5)]
    public void Worn_stripe_has_gaps_and_faded_paint(double wear, double share)
    {
        (double From, double To, Rgb Colour)[] left = [.. new PaintWear(17, wear).Left(3, Start, Length, Palette.White)];

        Assert.Equal(share, left.Sum(part => part.To - part.From) / Length, ShareTolerance);
        Assert.InRange(left.Min(part => part.From), Start, Start + MaxFirstGap);
        Assert.All(left, part => Assert.InRange(part.Colour.Red, Palette.White.Towards(Palette.Asphalt, wear).Red, Palette.White.Red));
        Assert.True(left.Select(part => part.Colour).Distinct().Count() > 10);
    }

    [Fact]
    public void Stripes_and_seeds_wear_differently_and_repeat()
    {
        (double, double, Rgb)[] Worn(int seed, int stripe) => [.. new PaintWear(seed, 0.5).Left(stripe, 0, Length, Palette.White)];

        Assert.Equal(Worn(1, 2), Worn(1, 2));
        Assert.NotEqual(Worn(1, 2), Worn(1, 3));
        Assert.NotEqual(Worn(1, 2), Worn(2, 2));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Worn_lines_are_where_new_ones_are()
    {
        IEnumerable<Vector3D> PointsAt(double wear) =>
            new SimulatedGame(new SimulationOptions { Seed = 71, PaintWear = wear })
                .Ports.Paint!.Near(Vector3D.Zero, 200)
                .SelectMany(line => line.Points)
                .Select(point => point.World);

        Assert.Equal(PointsAt(0), PointsAt(0.8));
    }
}
