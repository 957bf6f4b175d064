using Harvester.Datasets.Roads;
using Harvester.Geometry.Paint;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Xunit.Abstractions;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Measured stop lines and crossings against those that are painted, on roads whose lane widths are drawn at random. The seeds were not
/// used to choose the method's constants.
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
    public void Marks_of_random_towns_are_where_they_are_painted()
    {
        MarkJudge stopLines = new(MarkKind.StopLine);
        MarkJudge crossings = new(MarkKind.Crossing);
        foreach (int seed in TestSeeds.Or("257"))
        {
            string session = _folder.PathOf("session");
            string table = _folder.PathOf("paint.csv");
            string[] world = ["--varied-roads", "--seed", FormattableString.Invariant($"{seed}"), "--places", "18"];
            CliRun.Of(["harvest", "--out", session, "--overwrite", "--frames", "360", "--hz", "2", "--no-report", .. world]).AssertDone();
            CliRun.Of("roads", "paint", session, "--out", table).AssertDone();
            var game = new SimulatedGame(new SimulationOptions { Seed = seed, HasVariedRoads = true });
            PaintTable measured = PaintFile.Read(table, game.Roads);
            stopLines.Judge(measured, game.Marks, new SessionReader(session));
            crossings.Judge(measured, game.Marks, new SessionReader(session));
        }

        foreach (MarkJudge judge in new[] { stopLines, crossings })
        {
            output.WriteLine(judge.ToString());
            judge.Faults.ForEach(output.WriteLine);
        }

        Required(stopLines);
        Required(crossings);
    }

    private static void Required(MarkJudge judge)
    {
        Assert.InRange(judge.AlongMedian, 0, MaxAlongMedian);
        Assert.InRange((double)judge.False / judge.Measured, 0, MaxFalseShare);
    }
}
