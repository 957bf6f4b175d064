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
    private const double RequiredOfAll = 0.95;

    /// <summary>Some kinds still fail with a third of the seeds; docs/scenarios.md has the table.</summary>
    private const double RequiredOfEach = 0.5;

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
    public void Kinds_happen_in_generated_towns() => CheckAll(null, Seeds());

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
        CheckAll(roads, Seeds());
    }

    private static IEnumerable<int> Seeds() =>
        Environment.GetEnvironmentVariable("GTADATAHARVESTER_SCENARIO_SEEDS") is { Length: > 0 } range
        && range.Split('-') is [var first, var last]
            ? Enumerable.Range(
                int.Parse(first, CultureInfo.InvariantCulture),
                int.Parse(last, CultureInfo.InvariantCulture) - int.Parse(first, CultureInfo.InvariantCulture) + 1
            )
            : Enumerable.Range(3001, 3);

    private static ScenarioTemplate Template(string file)
    {
        ScenarioReading reading = ScenarioParser.Read(File.ReadAllText(file));
        Assert.Empty(reading.Problems);
        return reading.Template!;
    }

    /// <summary>Stages each kind with each seed, and asks how often what is described happened.</summary>
    private void CheckAll(RoadNetwork? roads, IEnumerable<int> seeds)
    {
        int[] all = [.. seeds];
        int[] happened = [.. Paths.Select(file => Happened(file, roads, all))];

        Assert.True(happened.Sum() >= RequiredOfAll * all.Length * happened.Length, $"{happened.Sum()} of {all.Length * happened.Length}");
        Assert.All(happened, count => Assert.True(count >= RequiredOfEach * all.Length, $"A kind: {count} of {all.Length}"));
    }

    private int Happened(string file, RoadNetwork? roads, IEnumerable<int> seeds)
    {
        ScenarioTemplate template = Template(file);
        int happened = 0;
        int staged = 0;
        int touched = 0;
        foreach (int seed in seeds)
        {
            string problem;
            staged++;
            try
            {
                StagedRecording recording = StagedRecording.Of(template, seed, roads);
                touched += recording.Record.Touched.Count > 0 ? 1 : 0;
                problem =
                    ScenarioOracle.Problem(template.Middle.Kind, new SceneTrace(recording.Moments), recording.Record.Scenario.Values) ?? "";
            }
            catch (UsageException e)
            {
                problem = e.Message;
            }

            happened += problem.Length == 0 ? 1 : 0;
            if (problem.Length > 0)
            {
                output.WriteLine($"{template.Middle.Kind} seed {seed}: {problem}");
            }
        }

        output.WriteLine($"{template.Middle.Kind}: {happened} of {staged}, touched {touched}");
        return happened;
    }
}
