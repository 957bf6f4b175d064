using System.Globalization;
using Harvester.Datasets.Roads;
using Harvester.Geometry.Roads;
using Harvester.Runs.Faults;
using Harvester.Sessions.Scenarios;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Runs.Tests.Scenarios;

/// <summary>Every scenario of the library, in generated towns and on GTA V's roads, judged from the poses that were recorded.</summary>
public class ScenarioKindTests(ITestOutputHelper output)
{
    /// <summary>What issue 42 requires of 20 seeds of each kind.</summary>
    private const double Required = 0.95;

    /// <summary>The first of the seeds that are used in turn, a kind each; a world is shared by kinds of the same seed.</summary>
    private const int FirstSeed = 3001;
    private const int Seeds = 3;

    private static string[] Paths => [.. Directory.GetFiles("scenarios", "*.json").Order(StringComparer.Ordinal)];

    [Fact]
    public void Library_has_24_kinds_that_differ_and_can_be_judged()
    {
        string[] kinds = [.. Paths.Select(file => Template(file).Middle.Kind)];
        Assert.True(kinds.Distinct().Count() >= 24);
        Assert.Equal(kinds.Order(StringComparer.Ordinal), ScenarioOracle.Kinds.Order(StringComparer.Ordinal));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Kinds_happen_in_generated_towns() => CheckAll(null, step: 1);

    [Fact]
    public void Actors_that_do_nothing_are_not_taken_for_what_is_described()
    {
        // The oracle refuses the leader that never brakes.
        ScenarioTemplate template = ScenarioParser
            .Read(
                File.ReadAllText("scenarios/hard-braking-leader.json")
                    .Replace("\"seconds\": \"$after\"", "\"seconds\": 500", StringComparison.Ordinal)
            )
            .Template!;
        StagedRecording recording = StagedRecording.Of(template, 1);
        Assert.NotNull(ScenarioOracle.Problem("hardBrakingLeader", new SceneTrace(recording.Moments), recording.Record.Scenario.Values));
    }

    [RealWorldFact("nodes.zip")]
    [Trait("Category", "Heavy")]
    public void Kinds_happen_on_the_roads_of_the_game()
    {
        RoadNetwork roads = RoadImporter.Import(RealWorldFactAttribute.PathOf("nodes.zip")!).Network;
        CheckAll(roads, step: 4);
    }

    /// <summary>All seeds of a measurement by hand, as in 4001-4020; null for those of the tests.</summary>
    private static int[]? MeasuredSeeds =>
        Environment.GetEnvironmentVariable("GTADATAHARVESTER_SCENARIO_SEEDS") is { Length: > 0 } range
        && range.Split('-') is [var first, var last]
            ? [.. Enumerable.Range(Number(first), Number(last) - Number(first) + 1)]
            : null;

    /// <summary>Words of which the kinds to measure have one in their names; all kinds if there are none.</summary>
    private static string[] MeasuredKinds =>
        (Environment.GetEnvironmentVariable("GTADATAHARVESTER_SCENARIO_KINDS") ?? "").Split(',', StringSplitOptions.RemoveEmptyEntries);

    private static int Number(string text) => int.Parse(text, CultureInfo.InvariantCulture);

    private static ScenarioTemplate Template(string file)
    {
        ScenarioReading reading = ScenarioParser.Read(File.ReadAllText(file));
        Assert.Empty(reading.Problems);
        return reading.Template!;
    }

    /// <summary>
    /// Stages every so many kinds with a seed, or in a measurement all with all seeds, and asks how often what is described happened. What
    /// cannot happen is skipped. Runs of a seed follow each other, because they share its town.
    /// </summary>
    private void CheckAll(RoadNetwork? roads, int step)
    {
        string[] words = MeasuredKinds;
        IEnumerable<(string File, int Seed)> chosen = MeasuredSeeds is { } all
            ? Paths
                .Where(file => words.Length == 0 || words.Any(word => file.Contains(word, StringComparison.Ordinal)))
                .SelectMany(file => all.Select(seed => (file, seed)))
            : Paths.Index().Where(each => each.Index % step == 0).Select(each => (each.Item, FirstSeed + (each.Index / step % Seeds)));
        KindCount[] counts =
        [
            .. chosen
                .OrderBy(each => each.Seed)
                .Select(each => (each.File, Count: Counted(each.File, roads, each.Seed)))
                .GroupBy(each => each.File, each => each.Count)
                .OrderBy(group => group.Key, StringComparer.Ordinal)
                .Select(group => group.Aggregate((sum, next) => sum + next)),
        ];
        foreach (KindCount count in counts)
        {
            output.WriteLine(count.ToString());
        }

        int happened = counts.Sum(count => count.Happened);
        int staged = counts.Sum(count => count.Staged);
        Assert.True(staged > 0, "Nothing was staged.");
        Assert.True(happened >= Required * staged, $"{happened} of {staged}");
        Assert.All(counts, count => Assert.True(count.Happened >= Required * count.Staged, count.ToString()));
    }

    private KindCount Counted(string file, RoadNetwork? roads, int seed)
    {
        ScenarioTemplate template = Template(file);
        string kind = template.Middle.Name;
        try
        {
            StagedRecording recording = StagedRecording.Of(template, seed, roads);
            SeenBody ego = recording.Moments[0].Ego;
            string? problem = ScenarioOracle.Problem(
                template.Middle.Kind,
                new SceneTrace(recording.Moments),
                recording.Record.Scenario.Values
            );
            if (problem is not null)
            {
                output.WriteLine(FormattableString.Invariant($"{kind} seed {seed} at {ego.X:0}, {ego.Y:0}: {problem}"));
            }

            return new KindCount(kind, Staged: 1, problem is null ? 1 : 0, recording.Record.Touched.Count > 0 ? 1 : 0, Skipped: 0);
        }
        catch (UsageException e)
        {
            output.WriteLine($"{kind} seed {seed} is skipped: {e.Message}");
            return new KindCount(kind, Staged: 0, Happened: 0, Touched: 0, Skipped: 1);
        }
    }
}
