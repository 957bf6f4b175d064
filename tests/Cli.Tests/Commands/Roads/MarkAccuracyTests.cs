using Harvester.Datasets.Roads;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Measured stop lines, crossings and arrows against those that are painted, on roads whose lane widths are drawn at random. The seeds were
/// not used to choose the method's constants.
/// </summary>
[Trait("Category", "Heavy")]
public sealed class MarkAccuracyTests(ITestOutputHelper output) : IDisposable
{
    /// <summary>Half of the width of a stop line, metres: then half of the measured bar lies beside the painted one.</summary>
    private const double MaxAlongMedian = 0.25;

    /// <summary>What is measured must be real in nine of ten cases; how much of what is in view is found is only reported.</summary>
    private const double MaxFalseShare = 0.1;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Marks_of_random_towns_are_found_from_above()
    {
        MarkJudge[] judges = [.. Enum.GetValues<MarkKind>().Select(kind => new MarkJudge(kind, MarkJudge.FromAbove))];
        foreach (int seed in TestSeeds.Or([351], [351, 352]))
        {
            string session = _folder.PathOf("session");
            string table = _folder.PathOf("paint.csv");
            string[] world = ["--varied-roads", "--seed", FormattableString.Invariant($"{seed}"), "--range", "200"];
            CliRun.Of(["roads", "photograph", "--out", session, "--overwrite", .. world]).AssertDone();
            CliRun.Of("roads", "paint", session, "--out", table).AssertDone();
            var game = new SimulatedGame(new SimulationOptions { Seed = seed, HasVariedRoads = true });
            PaintTable measured = PaintFile.Read(table, game.Roads);
            Array.ForEach(judges, judge => judge.Judge(measured, game.Marks, new SessionReader(session)));
        }

        Report(judges);
        Assert.All(judges, Required);
    }

    [Fact]
    public void Marks_of_random_towns_are_where_they_are_painted()
    {
        MarkJudge[] judges = [.. Enum.GetValues<MarkKind>().Select(kind => new MarkJudge(kind))];
        foreach (int seed in TestSeeds.Or([257], [257]))
        {
            string session = _folder.PathOf("session");
            string table = _folder.PathOf("paint.csv");
            string[] world = ["--varied-roads", "--seed", FormattableString.Invariant($"{seed}"), "--places", "18"];
            CliRun.Of(["harvest", "--out", session, "--overwrite", "--frames", "360", "--hz", "2", "--no-report", .. world]).AssertDone();
            CliRun.Of("roads", "paint", session, "--out", table).AssertDone();
            var game = new SimulatedGame(new SimulationOptions { Seed = seed, HasVariedRoads = true });
            PaintTable measured = PaintFile.Read(table, game.Roads);
            Array.ForEach(judges, judge => judge.Judge(measured, game.Marks, new SessionReader(session)));
        }

        Report(judges);
        // Cars pass few arrows, so that a town may give none of a kind.
        Assert.All(judges.Where((judge, kind) => kind <= (int)MarkKind.Crossing || judge.Measured > 0), Required);
    }

    private void Report(MarkJudge[] judges)
    {
        foreach (MarkJudge judge in judges)
        {
            output.WriteLine(judge.ToString());
            judge.Faults.ForEach(output.WriteLine);
        }
    }

    private static void Required(MarkJudge judge)
    {
        Assert.InRange(judge.AlongMedian, 0, MaxAlongMedian);
        Assert.InRange((double)judge.False / judge.Measured, 0, MaxFalseShare);
    }
}
