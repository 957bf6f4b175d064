using Harvester.Cli.Terminals;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Tests.Commands;

/// <summary>The inertial unit from the command line to the commands that read a session.</summary>
public sealed class HarvestImuTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Shards_and_resumed_sessions_have_the_noise_of_a_whole_one()
    {
        string[] frames = ["--frames", "4", "--places", "2", "--imu-noise", "adis16448"];
        string whole = Harvest("whole", frames);
        string[] parts = [.. Enumerable.Range(1, 2).Select(part => Harvest($"part-{part}", [.. frames, "--shard", $"{part}/2"]))];
        CliRun.Of(["merge", .. parts, "--out", _folder.PathOf("merged"), "--no-report"]).AssertDone();
        string torn = Harvest("torn", frames);
        string labels = Path.Combine(torn, "labels.jsonl");
        File.WriteAllText(labels, string.Concat(File.ReadAllLines(labels).Take(2).Select(line => line + "\n")));
        File.WriteAllText(
            Path.Combine(torn, ".harvester-unfinished"),
            "harvester harvest --size 64x48 --imu --seed 3 --no-report " + string.Join(' ', frames)
        );
        Harvest("torn", [.. frames, "--resume"]);

        string expected = File.ReadAllText(Path.Combine(whole, "labels.jsonl"));
        Assert.Equal(expected, File.ReadAllText(Path.Combine(_folder.PathOf("merged"), "labels.jsonl")));
        Assert.Equal(expected, File.ReadAllText(labels));
        CliRun.Of("validate", "--schema", whole).AssertDone();
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Noise_is_added_to_what_the_ideal_unit_measures()
    {
        ImuSample[] ideal = Samples(Harvest("ideal", "--frames", "2"));
        ImuSample[] noisy = Samples(Harvest("noisy", "--frames", "2", "--imu-noise", "gyro=0.001"));

        Assert.Equal(ideal.Select(sample => sample.TimeSeconds), noisy.Select(sample => sample.TimeSeconds));
        Assert.Equal(ideal.Select(sample => sample.SpecificForce), noisy.Select(sample => sample.SpecificForce));

        // 0.001 rad/s/√Hz at 60 samples a second are 0.0077 rad/s; no one of few samples is beyond five times that.
        Assert.All(ideal.Zip(noisy), pair => Assert.InRange((pair.First.AngularRate - pair.Second.AngularRate).Length, 1e-6, 0.067));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Relabelling_keeps_the_samples()
    {
        string session = Harvest("session", "--frames", "2", "--imu-noise", "accel=0.01");
        CliRun.Of("relabel", session, "--out", _folder.PathOf("again"), "--range", "30", "--no-report").AssertDone();
        CliRun.Of("validate", "--schema", _folder.PathOf("again")).AssertDone();

        Assert.Equal(Samples(session), Samples(_folder.PathOf("again")));
    }

    [Theory]
    [InlineData("--imu-noise needs --imu.", "--imu-noise", "gyro=1")]
    [InlineData("--imu-noise takes a comma-separated list of gyro=N", "--imu", "--imu-noise", "gyro")]
    [InlineData("--imu-noise takes a comma-separated list of gyro=N", "--imu", "--imu-noise", "gyro=-1")]
    [InlineData("at most 1, 0.1, 10 and 10", "--imu", "--imu-noise", "gyro=1000")]
    [InlineData("--imu-noise takes a comma-separated list of gyro=N", "--imu", "--imu-noise", "gyro=NaN")]
    [InlineData("--imu-noise takes a comma-separated list of gyro=N", "--imu", "--imu-noise", "gyro=1,speed=2")]
    public void Impossible_noise_is_refused(string message, params string[] options) =>
        CliRun.Of(["harvest", "--out", _folder.PathOf("out"), .. options]).AssertFailed(ExitCode.Usage, message);

    private static ImuSample[] Samples(string session) =>
        [.. new SessionReader(session).ReadLabels().SelectMany(label => label.Channels.Get<ImuLabel>()!.Samples)];

    private string Harvest(string name, params string[] options)
    {
        string session = _folder.PathOf(name);
        CliRun.Of(["harvest", "--out", session, "--size", "64x48", "--imu", "--seed", "3", "--no-report", .. options]).AssertDone();
        return session;
    }
}
