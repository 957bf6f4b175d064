using System.Globalization;
using Harvester.Runs.Evaluation.Scores;

namespace Harvester.Runs.Tests.Evaluation.Scores;

/// <summary>Scores by hand arithmetic and intervals of published tables; the tests of the Python package read the same files.</summary>
public sealed class ScoreVectorTests
{
    /// <summary>The published intervals have four decimals.</summary>
    private const double Rounded = 5e-5;

    public static TheoryData<string> Scores => Lines("driving-scores.csv");

    public static TheoryData<string> Intervals => Lines("poisson-intervals.csv");

    [Theory]
    [MemberData(nameof(Scores))]
    public void Score_is_completion_times_penalties(string line)
    {
        double[] n = NumbersOf(line);
        EpisodeScore score = new()
        {
            WantedMetres = n[0],
            DrivenMetres = n[1],
            OutsideMetres = n[2],
            Collisions = new CollisionCounts((int)n[3], (int)n[4], (int)n[5]),
            CollisionsOfBuiltInDriver = new CollisionCounts(0, 0, 0),
            RedLights = (int)n[6],
            StopSigns = (int)n[7],
            Stuck = 0,
        };

        double[] scores = [score.RouteCompletionFraction, score.PenaltyFraction, score.DrivingScore];

        Assert.Equal(n[8..], scores);
    }

    [Theory]
    [MemberData(nameof(Intervals))]
    public void Poisson_intervals_are_those_of_the_tables(string line)
    {
        double[] n = NumbersOf(line);
        PoissonInterval interval = PoissonInterval.Of((int)n[0]);

        Assert.Equal(n[1], interval.Low, Rounded);
        Assert.Equal(n[2], interval.High, Rounded);
    }

    private static TheoryData<string> Lines(string name) =>
        [.. File.ReadAllLines(Path.Combine(AppContext.BaseDirectory, "Evaluation", "Scores", name)).Skip(1)];

    private static double[] NumbersOf(string line) => [.. line.Split(',').Select(text => double.Parse(text, CultureInfo.InvariantCulture))];
}
