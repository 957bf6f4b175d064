using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>How often a matcher finds the true link and lane of a drive with noisy sensors.</summary>
/// <param name="Metres">Driven.</param>
/// <param name="FarFromJunctions">Of the samples that the drive itself has far from junctions.</param>
/// <param name="Known">Of the samples for which the matcher knows the lane: it matched a road, outside junctions.</param>
/// <param name="Outcomes">What was found of the samples that the matcher has outside junctions.</param>
internal sealed record DriveResult(double Metres, DriveShare FarFromJunctions, DriveShare Known, string Outcomes)
{
    public static DriveResult Of(NetworkDrive drive, RoadMatcher matcher, double metres, double positionNoise, double headingNoiseDegrees)
    {
        // Within three deviations of the position's noise along the road, either of two links that meet is right.
        double endOfLink = 3 * positionNoise;
        var random = new Random(7);
        var far = new DriveShare(0, 0);
        var known = new DriveShare(0, 0);
        var outcomes = new SortedDictionary<string, int>(StringComparer.Ordinal);
        RoadMatch? previous = null;
        foreach (DriveSample sample in drive.Samples(metres))
        {
            Vector3D position =
                sample.Position
                + new Vector3D(Normal(random) * positionNoise, Normal(random) * positionNoise, Normal(random) * positionNoise);
            RoadMatch match = matcher.Match(
                position,
                sample.HeadingDegrees + (Normal(random) * headingNoiseDegrees),
                sample.IsFirst ? null : previous
            );
            previous = match;
            bool isRight =
                match.Outcome == RoadMatchOutcome.Matched
                && (
                    IsAt(match, sample.Here)
                    || (sample.FromStart < endOfLink && IsAt(match, sample.Before))
                    || (sample.ToEnd < endOfLink && IsAt(match, sample.After))
                );
            far = sample.IsNearJunction ? far : far.With(isRight);
            if (!match.InJunction)
            {
                known = match.Outcome == RoadMatchOutcome.Matched ? known.With(isRight) : known;
                string what =
                    isRight ? "right"
                    : match.Outcome != RoadMatchOutcome.Matched ? match.Outcome.ToString()
                    : match.Link == sample.Here.Link ? "lane"
                    : "link";
                outcomes[what] = outcomes.GetValueOrDefault(what) + 1;
            }
        }

        return new DriveResult(drive.Driven, far, known, string.Join(", ", outcomes));
    }

    public override string ToString() =>
        string.Create(
            CultureInfo.InvariantCulture,
            $"{Metres / 1000:0.0} km; far from junctions {FarFromJunctions}; of known lanes {Known}; outside junctions {Outcomes}"
        );

    private static bool IsAt(RoadMatch match, DriveLane? lane) =>
        lane is { } there && match.Link == there.Link && match.IsForward == there.IsForward && match.Lane == there.Lane;

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
