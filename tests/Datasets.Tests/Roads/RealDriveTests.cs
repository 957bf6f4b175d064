using Harvester.Datasets.Roads;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>
/// A car with noisy sensors over the whole game's network. Where it truly is comes from the drive's own curves and lane offsets,
/// which share no code with the matcher.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class RealDriveTests(ITestOutputHelper output)
{
    private const double Kilometres = 100;
    private const double PositionNoise = 0.2;
    private const double HeadingNoiseDegrees = 2;

    /// <summary>Within three deviations of the position's noise along the road, either of two links that meet is right.</summary>
    private const double EndOfLink = 3 * PositionNoise;

    [RealWorldFact("nodes.zip")]
    public void Match_over_100_km_finds_link_and_lane_in_99_percent_of_the_samples_outside_junctions()
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        var matcher = new RoadMatcher(new RoadCurves(network), new LaneModel(network));
        var drive = new NetworkDrive(network, seed: 2026);
        var random = new Random(7);
        int outside = 0;
        int right = 0;
        var outcomes = new Dictionary<string, int>();
        RoadMatch? previous = null;
        foreach (DriveSample sample in drive.Samples(Kilometres * 1000))
        {
            Vector3D position = sample.Position + new Vector3D(Normal(random) * PositionNoise, Normal(random) * PositionNoise, Normal(random) * PositionNoise);
            RoadMatch match = matcher.Match(position, sample.HeadingDegrees + (Normal(random) * HeadingNoiseDegrees), sample.IsFirst ? null : previous);
            previous = match;
            if (sample.IsNearJunction)
            {
                continue;
            }

            outside++;
            bool isRight = match.Outcome == RoadMatchOutcome.Matched && (IsAt(match, sample.Here)
                || (sample.FromStart < EndOfLink && IsAt(match, sample.Before)) || (sample.ToEnd < EndOfLink && IsAt(match, sample.After)));
            right += isRight ? 1 : 0;
            string what = isRight ? "right" : match.Outcome != RoadMatchOutcome.Matched ? match.Outcome.ToString() : match.Link == sample.Here.Link ? "lane" : "link";
            outcomes[what] = outcomes.GetValueOrDefault(what) + 1;
        }

        output.WriteLine($"{outside} samples outside junctions of {drive.Driven / 1000:0.0} km, {100.0 * right / outside:0.000} % right; {string.Join(", ", outcomes)}");
        Assert.InRange(drive.Driven, Kilometres * 1000, double.MaxValue);
        Assert.InRange((double)right / outside, 0.99, 1);
    }

    private static bool IsAt(RoadMatch match, DriveLane? lane) =>
        lane is { } there && match.Link == there.Link && match.IsForward == there.IsForward && match.Lane == there.Lane;

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
