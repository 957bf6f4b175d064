using System.Globalization;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Events;
using Harvester.Sessions.Scenarios;
using Harvester.Simulation.World;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// Precision and recall of the events against an oracle, on drives and scenarios that provoke them. CI has time for one seed; with
/// GTADATAHARVESTER_EVENT_SEEDS=FIRST-LAST there must also be enough events of each kind.
/// </summary>
public class EventOracleTests(ITestOutputHelper output)
{
    private const int SeedInCI = 7001;
    private const double SecondsInCI = 8;
    private const int ScenariosInCI = 1;
    private const int SignsInCI = 1;
    private const int Signs = 6;
    private const double Seconds = 45;
    private const double Required = 0.98;
    private const int MinOfAKind = 10;
    private const int MinInCI = 2;

    /// <summary>Times of the world are added up tick by tick, so that a tick is not exactly as long as another.</summary>
    private const double Tick = 1.01 / 60;

    /// <summary>
    /// The lanes of the map and those of the town are made by different code from the same nodes: their ends before junctions, their edges
    /// in bends and their ways through junctions differ by up to some decimetres, which a vehicle passes in this time, seconds.
    /// </summary>
    private const double LaneTolerance = 0.25;

    /// <summary>The scenarios that provoke what ordinary traffic does not do, each with whether bodies collide.</summary>
    private static readonly (string File, bool HasCrashes)[] Provoking =
    [
        ("red-light-run-left", false),
        ("wrong-way-driver", false),
        ("red-light-run-right", true),
        ("stop-sign-ignored", false),
        ("cut-in-left", false),
        ("cut-in-right", true),
        ("oncoming-in-lane", true),
        ("hard-braking-leader", true),
    ];

    private static string? SeedRange => Environment.GetEnvironmentVariable("GTADATAHARVESTER_EVENT_SEEDS");

    [Fact]
    [Trait("Category", "Heavy")]
    public void Events_are_those_of_the_oracle()
    {
        var found = new SortedDictionary<EventKind, (int Detected, int True, int Right, int Recalled)>();
        foreach ((string name, ProvokedDrive drive) in Drives())
        {
            List<TrueEvent> truth = new EventOracle(drive.Truth).Find(SiteCache.Shared.Town(drive.Seed), drive.Seed);
            foreach (EventKind kind in Enum.GetValues<EventKind>())
            {
                List<TrueEvent> expected = truth.FindAll(each => each.Kind == kind);
                List<TrueEvent> detected = [.. drive.Events.Where(each => each.Kind == kind).Select(drive.WithHandles)];
                (int Detected, int True, int Right, int Recalled) sum = found.GetValueOrDefault(kind);
                found[kind] = (
                    sum.Detected + detected.Count,
                    sum.True + expected.Count,
                    sum.Right + detected.Count(each => expected.Exists(other => AreSame(each, other))),
                    sum.Recalled + expected.Count(each => detected.Exists(other => AreSame(each, other)))
                );
                foreach (TrueEvent alone in detected.Where(each => !expected.Exists(other => AreSame(each, other))))
                {
                    output.WriteLine($"{name}: only detected: {alone}");
                }

                foreach (TrueEvent alone in expected.Where(each => !detected.Exists(other => AreSame(each, other))))
                {
                    output.WriteLine($"{name}: only of the oracle: {alone}");
                }

                if (kind == EventKind.Collision)
                {
                    Assert.Equal(expected.Order().Select(each => each.Begin), detected.Order().Select(each => each.Begin));
                }
            }
        }

        foreach ((EventKind kind, (int detected, int expected, int right, int recalled)) in found)
        {
            output.WriteLine($"{kind}: {detected} detected, {right} of them right; {expected} true, {recalled} of them found");
        }

        foreach ((EventKind kind, (int detected, int expected, int right, int recalled)) in found)
        {
            Assert.True(expected >= (SeedRange is null ? 0 : MinOfAKind), $"only {expected} {kind}");
            Assert.True(right >= Required * detected, $"precision of {kind}");
            Assert.True(recalled >= Required * expected, $"recall of {kind}");
        }

        Assert.True(found.Values.Sum(each => each.True) >= MinInCI);
    }

    /// <summary>The drives and scenarios, made one by one: a drive has the poses of some thousand moments.</summary>
    private static IEnumerable<(string Name, ProvokedDrive Drive)> Drives()
    {
        bool isInCI = SeedRange is not { Length: > 0 };
        int[] ends = isInCI ? [SeedInCI] : [.. SeedRange!.Split('-').Select(end => int.Parse(end, CultureInfo.InvariantCulture))];
        foreach (int seed in Enumerable.Range(ends[0], ends[^1] - ends[0] + 1))
        {
            // Every second drive has collisions with consequences; in the others, bodies pass into each other.
            yield return ($"drive {seed}", ProvokedDrive.Of(seed, isInCI ? SecondsInCI : Seconds, hasCrashes: isInCI || seed % 2 == 0));
            yield return ($"stop signs {seed}", ProvokedDrive.PastStopSigns(seed, isInCI ? SignsInCI : Signs));
            foreach ((string file, bool hasCrashes) in Provoking.Take(isInCI ? ScenariosInCI : Provoking.Length))
            {
                ScenarioTemplate template = ScenarioParser.Read(File.ReadAllText($"scenarios/{file}.json")).Template!;
                ProvokedDrive? staged = null;
                try
                {
                    staged = ProvokedDrive.Staged(template, seed, hasCrashes);
                }
                catch (ScenarioUnfitException)
                {
                    // Not every town has a place for every scenario.
                }

                if (staged is not null)
                {
                    yield return ($"{file} {seed}", staged);
                }
            }
        }
    }

    /// <summary>
    /// Whether two events have the same kind and participants, and begin and end at the same time: within a tick, or as well as lanes are
    /// known where they decide.
    /// </summary>
    private static bool AreSame(TrueEvent a, TrueEvent b)
    {
        double tolerance = a.Kind is EventKind.NearMiss or EventKind.HardBraking or EventKind.Collision ? Tick : LaneTolerance;
        return (a.Kind, a.First, a.Second) == (b.Kind, b.First, b.Second)
            && Math.Abs(a.Begin - b.Begin) <= tolerance
            && Math.Abs(a.End - b.End) <= tolerance;
    }
}
