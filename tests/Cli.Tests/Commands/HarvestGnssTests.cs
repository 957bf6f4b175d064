using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The satellite receiver from the command line to the commands that read a session.</summary>
public sealed class HarvestGnssTests : IDisposable
{
    /// <summary>Labels have four decimals of metres: half of the last in each of three directions, on both sides.</summary>
    private const double Rounding = 2e-4;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Samples_are_where_the_vehicle_is_at_their_ticks()
    {
        string session = Harvest("session", "--imu", "--motion");
        CliRun.Of("validate", "--schema", session).AssertDone();
        CliRun.Of("relabel", session, "--out", _folder.PathOf("again"), "--range", "30", "--no-report").AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("again")).AssertDone();
        CliRun.Of("export", session, "--format", "euroc", "--out", _folder.PathOf("euroc")).AssertDone();
        CliRun.Of("validate", _folder.PathOf("euroc")).AssertDone();

        FrameLabel[] labels = [.. new SessionReader(_folder.PathOf("again")).ReadLabels()];
        Assert.Equal(2, labels.Length);
        int compared = 0;
        foreach (FrameLabel label in labels)
        {
            foreach (GnssSample sample in label.Channels.Get<GnssLabel>()!.Samples)
            {
                MotionSample? tick = label.Motion!.FirstOrDefault(each => Math.Abs(each.TimeSeconds - sample.TimeSeconds) < 1e-6);
                Vector3D place = tick?.Position ?? label.Ego.Position;
                Vector3D velocity = tick?.Velocity ?? label.Ego.Velocity;
                Assert.True(tick is not null || Math.Abs(label.TimeSeconds - sample.TimeSeconds) < 1e-6, "It is at no tick.");
                (double latitude, double longitude, double height) = Wgs84.Of(place);
                Assert.InRange(Math.Abs(latitude - sample.LatitudeDegrees) * 111_000, 0, Rounding);
                Assert.InRange(Math.Abs(longitude - sample.LongitudeDegrees) * 111_000, 0, Rounding);
                Assert.InRange(Math.Abs(height - sample.Altitude), 0, Rounding);
                Assert.InRange((velocity - sample.Velocity).Length, 0, Rounding);
                compared++;
            }
        }

        Assert.True(compared > 5, $"Only {compared} samples.");
        int samples = labels.Sum(label => label.Channels.Get<GnssLabel>()!.Samples.Count);
        Assert.Equal(1 + samples, File.ReadAllLines(_folder.PathOf("euroc/train/0000/mav0/gnss0/data.csv")).Length);
    }

    [Fact]
    public void Samples_out_of_order_are_a_problem()
    {
        string session = Harvest("wrong");
        string labels = Path.Combine(session, "labels.jsonl");
        File.WriteAllText(
            labels,
            File.ReadAllText(labels).Replace("\"gnss\":{\"timesSeconds\":[", "\"gnss\":{\"timesSeconds\":[9", StringComparison.Ordinal)
        );
        File.Delete(Path.Combine(session, "manifest.jsonl"));

        CliRun validated = CliRun.Of("validate", session);

        Assert.Equal(ExitCode.BadData, validated.ExitCode);
        Assert.Contains("sample 0 of gnss is not before what follows it.", validated.Out, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--gnss-noise needs --gnss.", "--gnss-noise", "horizontal=1")]
    [InlineData("--gnss-noise takes a comma-separated list of horizontal=N", "--gnss", "--gnss-noise", "horizontal")]
    [InlineData("--gnss-noise takes a comma-separated list of horizontal=N", "--gnss", "--gnss-noise", "horizontal=-1")]
    [InlineData("at most 100, 100, 1, 1 and 10", "--gnss", "--gnss-noise", "horizontalWalk=2")]
    public void Other_noise_is_refused(string message, params string[] options) =>
        CliRun
            .Of(["harvest", "--out", _folder.PathOf("refused"), "--frames", "1", "--size", "80x60", "--no-report", .. options])
            .AssertFailed(ExitCode.Usage, message);

    private string Harvest(string name, params string[] options)
    {
        string session = _folder.PathOf(name);
        string[] fixedOptions = ["--frames", "2", "--hz", "2", "--places", "1", "--size", "80x60", "--seed", "3", "--no-report", "--gnss"];
        CliRun.Of(["harvest", "--out", session, .. fixedOptions, .. options]).AssertDone();
        return session;
    }
}
