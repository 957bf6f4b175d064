using Harvester.Geometry.Lanes;

namespace Harvester.Simulation.Streets;

/// <summary>
/// Lane widths and paint drawn at random for each road, so that no constant describes them. A road's draw depends on the seed and its ends
/// alone.
/// </summary>
internal static class RandomRoads
{
    private const double MinLane = 3.0;
    private const double MaxLane = 6.5;
    private const double ShareWithoutEdges = 0.15;
    private const double ShareWithArrows = 0.6;

    public static RoadChain Vary(RoadChain chain, int seed)
    {
        var random = new Random(unchecked((((seed * 31) + chain.Nodes[0]) * 31) + chain.Nodes[^1]));
        double Between(double from, double to) => from + ((to - from) * random.NextDouble());
        double lane = Between(MinLane, MaxLane);
        double stripe = Between(0.1, 0.2);
        double dash = Between(2, 4);
        var paint = new RoadPaint
        {
            StripeWidth = stripe,
            BetweenStripes = stripe + Between(0.12, 0.2),
            DashLength = dash,
            DashPeriod = dash * Between(2.2, 3.5),
            EdgeInset = Between(0.15, lane / 5),
            HasEdges = random.NextDouble() >= ShareWithoutEdges,
            HasYellowLeftEdge = random.NextDouble() < 0.5,
            Centre = random.Next(3) switch
            {
                0 => MarkingStyle.Solid,
                1 => MarkingStyle.Dashed,
                _ => MarkingStyle.DoubleSolid,
            },
            ArrowLength = random.NextDouble() < ShareWithArrows ? Between(2.5, 4.5) : 0,
        };
        return chain with { Layout = chain.Layout with { LaneWidth = lane, Paint = paint } };
    }
}
