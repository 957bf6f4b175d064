using Harvester.Datasets.Roads;
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

    [RealWorldFact("nodes.zip")]
    public void Match_over_100_km_finds_99_percent_of_links_and_lanes()
    {
        RoadNetwork network = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        var matcher = new RoadMatcher(new RoadCurves(network), new LaneModel(network));

        DriveResult result = DriveResult.Of(
            new NetworkDrive(network, seed: 2026),
            matcher,
            Kilometres * 1000,
            PositionNoise,
            HeadingNoiseDegrees
        );

        output.WriteLine(result.ToString());
        Assert.InRange(result.Metres, Kilometres * 1000, double.MaxValue);
        Assert.InRange(result.FarFromJunctions.RightFraction, 0.99, 1);
        Assert.InRange(result.Known.RightFraction, 0.99, 1);
    }
}
