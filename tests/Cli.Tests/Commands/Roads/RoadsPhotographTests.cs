using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>harvester roads photograph on a straight road of 400 m.</summary>
public sealed class RoadsPhotographTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public RoadsPhotographTests() => File.WriteAllText(Roads, WritingCommand.Roads);

    private string Roads => _folder.PathOf("roads.csv");

    private string Above => _folder.PathOf("above");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Session_shows_the_road_from_above_and_is_valid()
    {
        CliRun run = Photograph("--range", "50");

        run.AssertDone();
        Assert.Contains("0.10 km of roads from above in 2 pictures of 1600 x 900", run.Out, StringComparison.Ordinal);
        Assert.Contains("roads paint", run.Out, StringComparison.Ordinal);
        FrameLabel[] labels = [.. new SessionReader(Above).ReadLabels()];
        Assert.Equal(2, labels.Length);
        Assert.All(
            labels,
            label =>
            {
                Assert.Equal(-1, label.Camera.Pose.Axes.Forward.Z, 0.01);
                Assert.Equal(33.776, (label.Camera.Pose.Position - label.Ego.Position).Length, 0.01);
                Assert.Empty(label.Objects);
                Assert.NotNull(label.Depth?.Completed);
            }
        );
        CliRun.Of("validate", Above).AssertDone();
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Survey_is_the_same_in_every_run()
    {
        Photograph("--range", "40").AssertDone();
        string labels = File.ReadAllText(Path.Combine(Above, "labels.jsonl"));
        CliRun again = Photograph("--range", "40", "--resume");
        again.AssertDone();
        Assert.Contains("finished already", again.Out, StringComparison.Ordinal);

        Photograph("--range", "40", "--overwrite").AssertDone();
        Assert.Equal(labels, File.ReadAllText(Path.Combine(Above, "labels.jsonl")));
    }

    [Fact]
    public void Place_without_roads_is_refused() =>
        CliRun
            .Of("roads", "photograph", "--roads", Roads, "--near=900,0", "--range", "50", "--out", Above)
            .AssertFailed(ExitCode.Usage, "No road lies within 50 m of 900, 0; choose another --near or --range.");

    [Theory]
    [InlineData("--range", "5")]
    [InlineData("--metres-per-pixel", "0.1")]
    public void Value_out_of_range_is_refused(string option, string value) =>
        CliRun.Of("roads", "photograph", "--roads", Roads, option, value, "--out", Above).AssertFailed(ExitCode.Usage, option);

    private CliRun Photograph(params string[] options) =>
        CliRun.Of(["roads", "photograph", "--roads", Roads, "--near=0,-50", "--image-format", "jpg", "--out", Above, .. options]);
}
