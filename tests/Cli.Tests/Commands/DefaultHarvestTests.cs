using System.Globalization;
using System.Text.RegularExpressions;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The figures that issue 20 requires of 1,000 frames harvested with the defaults, as harvester stats reports them.</summary>
public sealed partial class DefaultHarvestTests
{
    private const double LeastActivePercent = 5;
    private const double LeastDeviationMetres = 0.5;
    private const double LeastAngleRadians = 0.2;
    private const double MostSmallPercent = 50;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Default_harvest_is_worth_learning_from()
    {
        using var folder = new TemporaryFolder();
        string session = folder.PathOf("session");
        CliRun.Of("harvest", "--frames", "1000", "--out", session, "--no-report").AssertDone();

        string stats = CliRun.Of("stats", session).Out;

        double[] active = [.. ActiveShare().Matches(stats).Select(match => Number(match.Groups[1].Value))];
        Assert.Equal(13, active.Length);
        Assert.All(active, percent => Assert.InRange(percent, LeastActivePercent, 100));
        Assert.InRange(Number(Deviation().Match(stats).Groups[1].Value), LeastDeviationMetres, 10);
        Assert.InRange(Number(SmallShare().Match(stats).Groups[1].Value), 0, MostSmallPercent);
        Assert.Contains("classes without labels: none\n", stats, StringComparison.Ordinal);

        FrameLabel[] labels = [.. new SessionReader(session).ReadLabels()];
        Assert.Contains(labels, label => Math.Abs(label.Lanes!.Indicators.Angle.Value) >= LeastAngleRadians);
        Assert.Equal(10, labels.Select(label => label.Place).Distinct().Count());
        Manoeuvre[] seen = [.. labels.Select(label => label.Ego.Motion!.Manoeuvre!.Value).Distinct()];
        Assert.Contains(Manoeuvre.Follow, seen);
        Assert.Contains(Manoeuvre.Drift, seen);
        Assert.Contains(Manoeuvre.Recover, seen);
        Assert.Contains(seen, manoeuvre => manoeuvre is Manoeuvre.LaneChangeLeft or Manoeuvre.LaneChangeRight);
    }

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    [GeneratedRegex("(?:angle|toMarking[LMR]+|dist[LMR]+): ([0-9.]+) % of")]
    private static partial Regex ActiveShare();

    [GeneratedRegex("lateral offset, m: standard deviation ([0-9.]+),")]
    private static partial Regex Deviation();

    [GeneratedRegex("labels under 25 px high: [0-9]+ of [0-9]+, ([0-9.]+) %")]
    private static partial Regex SmallShare();
}
