using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The places that a harvest visits, and the factors of what happens there.</summary>
public sealed class HarvestVarietyTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    private string Session => _folder.PathOf("session");

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Places_lie_apart_and_number_their_frames()
    {
        Harvest("--frames", "8", "--places", "4").AssertDone();

        FrameLabel[] labels = [.. new SessionReader(Session).ReadLabels()];
        Assert.Equal([0, 0, 1, 1, 2, 2, 3, 3], labels.Select(label => label.Place));
        Assert.Equal([0, 1, 0, 1, 0, 1, 0, 1], labels.Select(label => label.PlaceFrame));
        Assert.Equal(labels.Select(label => label.TimeSeconds).Order(), labels.Select(label => label.TimeSeconds));
        Assert.Equal(labels.Select(label => label.GameFrame).Order().Distinct(), labels.Select(label => label.GameFrame));
        Vector3D[] starts = [.. labels.Where(label => label.PlaceFrame == 0).Select(label => label.Ego.Position)];
        Assert.All(starts, start => Assert.DoesNotContain(starts, other => other != start && (other - start).Length < 50));
        Assert.Equal(
            4,
            labels.SelectMany(label => label.Objects.Select(item => (label.Place, item.Id))).Distinct().GroupBy(pair => pair.Place).Count()
        );
        Assert.All(
            labels.SelectMany(label => label.Objects.Select(item => (label.Place, item.Id))).Distinct().GroupBy(pair => pair.Id),
            places => Assert.Single(places)
        );
        Assert.Equal(ExitCode.Done, CliRun.Of("validate", Session).ExitCode);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labels_tell_what_the_car_does_and_relabelling_keeps_it()
    {
        Harvest("--frames", "6", "--places", "2").AssertDone();
        FrameLabel[] labels = [.. new SessionReader(Session).ReadLabels()];
        Assert.All(labels, label => Assert.NotNull(label.Ego.Motion!.Manoeuvre));

        string again = _folder.PathOf("again");
        CliRun.Of("relabel", Session, "--out", again).AssertDone();

        Assert.Equal(labels.Select(label => label.Ego.Motion), new SessionReader(again).ReadLabels().Select(label => label.Ego.Motion));
        Assert.Equal(labels.Select(label => label.Place), new SessionReader(again).ReadLabels().Select(label => label.Place));
    }

    [Fact]
    public void Factors_of_0_give_empty_roads_and_a_steady_car()
    {
        Harvest("--frames", "4", "--wander", "0", "--lane-changes", "0", "--traffic", "0", "--pedestrians", "0", "--parked", "0")
            .AssertDone();

        FrameLabel[] labels = [.. new SessionReader(Session).ReadLabels()];
        Assert.All(labels, label => Assert.Null(label.Ego.Motion!.Manoeuvre));
        Assert.All(labels.SelectMany(label => label.Objects), item => Assert.Contains(item.Class.ToString(), "Sign TrafficLight"));
    }

    [Theory]
    [InlineData("--wander", "-1", "a number from 0 to 3")]
    [InlineData("--lane-changes", "6", "a number from 0 to 5")]
    [InlineData("--traffic", "many", "a number from 0 to 4")]
    [InlineData("--pedestrians", "NaN", "a number from 0 to 5")]
    [InlineData("--parked", "3", "a number from 0 to 2.5")]
    [InlineData("--places", "0", "a whole number from 1 to 10000")]
    [InlineData("--places", "2.5", "a whole number from 1 to 10000")]
    [InlineData("--places", "9", "--places 9 needs at least as many --frames, not 2.")]
    public void Factor_out_of_range_is_a_usage_error(string option, string value, string message)
    {
        Harvest("--frames", "2", option, value).AssertFailed(ExitCode.Usage, message);
        Assert.False(Directory.Exists(Session));
    }

    [Fact]
    public void More_places_than_the_town_has_are_a_usage_error()
    {
        Harvest("--frames", "5000", "--places", "5000").AssertFailed(ExitCode.Usage, "fewer than the 5000 of --places");
        Assert.False(Directory.Exists(Session));
    }

    private CliRun Harvest(params string[] options) =>
        CliRun.Of(["harvest", "--out", Session, "--size", "160x120", "--seed", "5", "--no-report", .. options]);
}
