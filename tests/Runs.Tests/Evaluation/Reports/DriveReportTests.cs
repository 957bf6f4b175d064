using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Runs.Evaluation.Reports;
using Harvester.Runs.Evaluation.Scores;
using Harvester.Runs.Tests.Evaluation.Figures;

namespace Harvester.Runs.Tests.Evaluation.Reports;

public sealed class DriveReportTests
{
    [Fact]
    public void Page_has_the_figures_and_a_ring_for_each_event()
    {
        DriveSample[] samples = [Drives.At(0), Drives.At(1) with { Touching = [4] }, Drives.At(2), Drives.At(3)];
        DriveRecord record = RecordOf(samples);
        string page = PageOf(record);

        Assert.All(
            record.Figures.Rows().Concat(record.Summary.Rows()),
            row => Assert.Contains($"<tr><td>{row.Name}</td><td>{row.Value}</td></tr>", page, StringComparison.Ordinal)
        );
        Assert.Single(record.Collisions);
        Assert.Single(Regex.Matches(page, "<circle class=\"collision\""));
        Assert.DoesNotContain("<circle class=\"departure\"", page, StringComparison.Ordinal);
    }

    [Fact]
    public void Speed_jerk_and_progress_are_plotted_to_scale()
    {
        // Speeds 0, 1, 3, 6, 10: second differences of 1 m/s in a tenth of a second, 100 m/s³ each.
        double[] speeds = [0, 1, 3, 6, 10];
        DriveSample[] samples = [.. speeds.Select((speed, i) => Drives.At(i) with { Speed = speed })];
        string[] plots =
        [
            .. Regex.Matches(PageOf(RecordOf(samples)), "<svg.*?</svg>", RegexOptions.Singleline).Select(match => match.Value),
        ];

        Assert.Equal(5, plots.Length);
        (double X, double Y)[] speed = PointsOf(plots[2]);
        Assert.All(Enumerable.Range(0, 5), i => Assert.Equal(speeds[i] / 10, (speed[0].Y - speed[i].Y) / (speed[0].Y - speed[4].Y), 0.01));
        (double X, double Y)[] jerk = PointsOf(plots[3]);
        Assert.Equal(3, jerk.Length);
        Assert.All(jerk, point => Assert.Equal(jerk[0].Y, point.Y));

        // A metre in each tenth of a second: a straight line.
        (double X, double Y)[] progress = PointsOf(plots[4]);
        Assert.All(
            Enumerable.Range(0, 5),
            i => Assert.Equal(i / 4.0, (progress[i].X - progress[0].X) / (progress[4].X - progress[0].X), 0.01)
        );
        Assert.All(
            Enumerable.Range(0, 5),
            i => Assert.Equal(i / 4.0, (progress[0].Y - progress[i].Y) / (progress[0].Y - progress[4].Y), 0.01)
        );
    }

    [Theory]
    [InlineData("lookAheadMetres", "10", "<dt>look ahead</dt><dd>10 m</dd>")]
    [InlineData("durationSeconds", "60", "<dt>duration</dt><dd>60 s</dd>")]
    [InlineData("roads", "<my> & roads", "<dt>roads</dt><dd>&lt;my&gt; &amp; roads</dd>")]
    public void Settings_are_named_in_words_with_units(string key, string value, string expected)
    {
        DriveRecord record = RecordOf([Drives.At(0)]);
        record = record with
        {
            Settings = new Dictionary<string, string> { ["controller"] = "stanley", [key] = value },
        };

        Assert.Contains(expected, PageOf(record), StringComparison.Ordinal);
    }

    private static DriveRecord RecordOf(DriveSample[] samples) =>
        DriveRecord.Of(
            new Dictionary<string, string> { ["controller"] = "stanley" },
            [new DriveEpisode(1, null, samples, 100, isStopped: false)]
        );

    private static (double X, double Y)[] PointsOf(string plot) =>
        [
            .. Regex
                .Match(plot, "<polyline class=\"controller\" points=\"([^\"]*)\"")
                .Groups[1]
                .Value.Split(' ')
                .Select(point => point.Split(','))
                .Select(point =>
                    (double.Parse(point[0], CultureInfo.InvariantCulture), double.Parse(point[1], CultureInfo.InvariantCulture))
                ),
        ];

    private static string PageOf(DriveRecord record)
    {
        using var page = new MemoryStream();
        DriveReport.Write(page, record);
        return Encoding.UTF8.GetString(page.ToArray());
    }
}
