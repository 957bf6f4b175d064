using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>How often a matcher finds the true link and lane of a drive with noisy sensors, outside junctions.</summary>
internal sealed record DriveResult(double Metres, int Samples, int Right, string Outcomes)
{
    public double RightFraction => (double)Right / Samples;

    public static DriveResult Of(NetworkDrive drive, RoadMatcher matcher, double metres, double positionNoise, double headingNoiseDegrees)
    {
        // Within three deviations of the position's noise along the road, either of two links that meet is right.
        double endOfLink = 3 * positionNoise;
        var random = new Random(7);
        int outside = 0;
        int right = 0;
        var outcomes = new SortedDictionary<string, int>(StringComparer.Ordinal);
        RoadMatch? previous = null;
        foreach (DriveSample sample in drive.Samples(metres))
        {
            Vector3D position = sample.Position + new Vector3D(Normal(random) * positionNoise, Normal(random) * positionNoise, Normal(random) * positionNoise);
            RoadMatch match = matcher.Match(position, sample.HeadingDegrees + (Normal(random) * headingNoiseDegrees), sample.IsFirst ? null : previous);
            previous = match;
            if (sample.IsNearJunction)
            {
                continue;
            }

            outside++;
            bool isRight = match.Outcome == RoadMatchOutcome.Matched && (IsAt(match, sample.Here)
                || (sample.FromStart < endOfLink && IsAt(match, sample.Before)) || (sample.ToEnd < endOfLink && IsAt(match, sample.After)));
            right += isRight ? 1 : 0;
            string what = isRight ? "right" : match.Outcome != RoadMatchOutcome.Matched ? match.Outcome.ToString() : match.Link == sample.Here.Link ? "lane" : "link";
            outcomes[what] = outcomes.GetValueOrDefault(what) + 1;
        }

        return new DriveResult(drive.Driven, outside, right, string.Join(", ", outcomes));
    }

    public override string ToString() =>
        string.Create(CultureInfo.InvariantCulture, $"{Samples} samples outside junctions of {Metres / 1000:0.0} km, {100 * RightFraction:0.000} % right; {Outcomes}");

    private static bool IsAt(RoadMatch match, DriveLane? lane) =>
        lane is { } there && match.Link == there.Link && match.IsForward == there.IsForward && match.Lane == there.Lane;

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
