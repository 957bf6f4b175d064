using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The figures required of a harvest with the defaults, as harvester stats reports them.</summary>
public sealed partial class DefaultHarvestTests
{
    private const double MinActivePercent = 5;
    private const double MinDeviationMetres = 0.5;
    private const double MinAngleRadians = 0.2;
    private const double MaxSmallPercent = 50;
    private const int SeedWithRoomForLaneChanges = 1;

    /// <summary>Numbers of frames, each with a seed.</summary>
    public static TheoryData<int, int> Harvests
    {
        get
        {
            var harvests = new TheoryData<int, int> { { 100, 1 }, { 1000, 31 } };
            foreach (int seed in ProofSize.Of([], [1]))
            {
                harvests.Add(1000, seed);
            }

            return harvests;
        }
    }

    [Theory]
    [MemberData(nameof(Harvests))]
    [Trait("Category", "Heavy")]
    public void Default_harvest_is_worth_learning_from(int frames, int seed)
    {
        FrameLabel[] labels = LabelsWorthLearningFrom(frames, "--seed", Invariant(seed));

        Manoeuvre[] seen = [.. labels.Select(label => label.Ego.Motion!.Manoeuvre!.Value).Distinct()];
        Assert.Contains(Manoeuvre.Drift, seen);
        if (frames == 1000)
        {
            Assert.Contains(Manoeuvre.Follow, seen);
            Assert.Contains(Manoeuvre.Recover, seen);
        }

        // In other places there may be no second lane with a gap.
        if (seed == SeedWithRoomForLaneChanges)
        {
            Assert.Contains(seen, manoeuvre => manoeuvre is Manoeuvre.LaneChangeLeft or Manoeuvre.LaneChangeRight);
        }
    }

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Harvest_of_real_roads_is_worth_learning_from() =>
        LabelsWorthLearningFrom(1000, "--roads", RealWorldFactAttribute.PathOf("nodes.zip")!);

    private static FrameLabel[] LabelsWorthLearningFrom(int frames, params string[] options)
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");

        // The plain picture has the same labels and is drawn faster.
        CliRun
            .Of(["harvest", "--frames", Invariant(frames), "--out", session, "--no-report", "--detail", "plain", .. options])
            .AssertDone();

        string stats = CliRun.Of("stats", session).Out;

        double[] active = [.. ActiveShare().Matches(stats).Select(match => Number(match.Groups[1].Value))];
        Assert.Equal(13, active.Length);
        Assert.True(active.Min() >= MinActivePercent, stats);
        Assert.InRange(Number(Deviation().Match(stats).Groups[1].Value), MinDeviationMetres, 10);
        Assert.InRange(Number(SmallShare().Match(stats).Groups[1].Value), 0, MaxSmallPercent);
        Assert.Contains("classes without labels: none\n", stats, StringComparison.Ordinal);

        FrameLabel[] labels = [.. new SessionReader(session).ReadLabels()];
        Assert.Contains(labels, label => Math.Abs(label.Lanes!.Indicators.Angle.Value) >= MinAngleRadians);
        Assert.Equal(10, labels.Select(label => label.Place).Distinct().Count());
        return labels;
    }

    private static string Invariant(int number) => number.ToString(CultureInfo.InvariantCulture);

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    [GeneratedRegex("(?:angle|toMarking[LMR]+|dist[LMR]+): ([0-9.]+) % of")]
    private static partial Regex ActiveShare();

    [GeneratedRegex("lateral offset, m: standard deviation ([0-9.]+),")]
    private static partial Regex Deviation();

    [GeneratedRegex("labels under 25 px high: [0-9]+ of [0-9]+, ([0-9.]+) %")]
    private static partial Regex SmallShare();
}
