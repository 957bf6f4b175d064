using Harvester.Capture.Harvesting;
using Harvester.Capture.SelfTests;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.SelfTests;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.SelfTests;

/// <summary>The self-test of the mod in simulated games with quirks: it finds each quirk, and nothing else.</summary>
public sealed class SelfTestTests(ITestOutputHelper output)
{
    private const double TicksPerSecond = 60;
    private const int MaxTicks = 5_000;

    /// <summary>Offsets are added to the camera's place and subtracted again.</summary>
    private const double RoundingMetres = 1e-9;

    /// <summary>CI tries every third quirk alone, and every tenth combination.</summary>
    public static TheoryData<string> Names
    {
        get
        {
            string[] all = [.. QuirkCombination.All.Keys];
            string[] combined = [.. QuirkCombination.Combined.Keys];
            IEnumerable<string> alone = all.Except(combined).Where((_, index) => index % 3 == 0);
            return [.. ProofSize.Of([.. alone, .. combined.Where((_, index) => index % 10 == 0)], all)];
        }
    }

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Names))]
    public void Each_quirk_is_found_and_no_other(string name)
    {
        QuirkCombination combination = QuirkCombination.All[name];
        var game = new SimulatedGame(Town(combination.Quirks) with { Lens = combination.Lens ?? RenderLens.None });
        var test = new SelfTest(Options, game.Ports);
        int ticks = Run(game, test);
        output.WriteLine($"{ticks} ticks");
        output.WriteLine(string.Join("\n", test.Lines.Select(line => $"{line.Check}: {line.Verdict}: {line.Sentence}")));

        Assert.Equal(SelfTestPhase.Done, test.Phase);
        Assert.Equal(SelfTestChecks.All, test.Lines.Select(line => line.Check));
        Assert.Equal(
            combination.Checks.Order(StringComparer.Ordinal),
            test.Lines.Where(line => line.Verdict is SelfTestVerdict.Note or SelfTestVerdict.Problem)
                .Select(line => line.Check)
                .Order(StringComparer.Ordinal)
        );
        AssertLeftNothing(game);
    }

    [Fact]
    public void Thirty_combinations_and_more_are_tried() => Assert.InRange(QuirkCombination.Combined.Count, 30, int.MaxValue);

    private static HarvestOptions Options => new() { Image = new ImageSize(400, 300) };

    private static SimulationOptions Town(GameQuirks quirks) =>
        new()
        {
            Seed = 61,
            WindowAspect = 4.0 / 3,
            IsWarm = true,
            Detail = Detail.Plain,
            TimeOfDay = TimeSpan.FromHours(12),
            Quirks = quirks,
        };

    private static int Run(SimulatedGame game, SelfTest test)
    {
        int ticks = 0;
        for (int tick = 0; tick < 120; tick++)
        {
            game.Tick(1 / TicksPerSecond);
        }

        while (test.Step() == SelfTestPhase.Running && ticks < MaxTicks)
        {
            game.Tick(1 / TicksPerSecond);
            ticks++;
        }

        return ticks;
    }

    private static void AssertLeftNothing(SimulatedGame game)
    {
        for (int tick = 0; tick < 30; tick++)
        {
            game.Tick(1 / TicksPerSecond);
        }

        Assert.False(game.IsFrozen);
        Assert.Empty(game.Hidden.Current);
        Assert.Empty(game.Markers);
        Assert.Empty(game.Sheets);
        Assert.Empty(game.Layers.Card);
        Assert.InRange((new Vector3D(0, 2, 0.4) - game.CameraMount.Position).Length, 0, RoundingMetres);
    }
}
