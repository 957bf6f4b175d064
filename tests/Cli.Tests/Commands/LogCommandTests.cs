using Harvester.Cli.Terminals;
using Harvester.Geometry;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;

namespace Harvester.Cli.Tests.Commands;

/// <summary>A harvest goes out as a log, comes in again, and is replayed: everything is where it was.</summary>
public sealed class LogCommandTests : IDisposable
{
    /// <summary>Between steps of 0.1 s, a straight line leaves the path of a car that changes its velocity by 8 m/s² by a·t²/8, metres;
    /// and numbers are rounded.</summary>
    private const double OnPath = 0.012;

    /// <summary>The same of a heading that changes by 1 rad/s within a step, radians.</summary>
    private const double Turn = 0.02;

    /// <summary>Roads made of lanes differ in height by this between their nodes, metres.</summary>
    private const double OnRoad = 0.1;

    /// <summary>A log has no pavements: who walks beside the lanes stands on ground that is continued from the nearest road, and without
    /// the kerb of 0.15 m, metres. docs/logs.md states it.</summary>
    private const double BesideRoad = 0.4;

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("gpudrive", "train/0000_0000.json")]
    [InlineData("womd", "train.tfrecord-00000-of-00001")]
    [Trait("Category", "Heavy")]
    public void Replayed_log_of_a_harvest_has_everything_where_it_was(string format, string file)
    {
        string first = _folder.PathOf("first");
        CliRun
            .Of(
                "harvest",
                "--out",
                first,
                "--seed",
                "17",
                "--hz",
                "10",
                "--frames",
                "45",
                "--places",
                "1",
                "--size",
                "64x48",
                "--no-report"
            )
            .AssertDone();
        CliRun.Of("export", first, "--format", format, "--out", _folder.PathOf("export")).AssertDone();
        CliRun.Of("log", "import", _folder.PathOf($"export/{file}"), "--out", _folder.PathOf("logs")).AssertDone();
        string second = _folder.PathOf("second");
        CliRun
            .Of("harvest", "--log", _folder.PathOf("logs/0000"), "--out", second, "--hz", "10", "--size", "64x48", "--no-report")
            .AssertDone();

        (double Seconds, RecordedScene Scene)[] before = Scenes(first);
        double start = before[0].Seconds;
        int compared = 0;
        foreach ((double seconds, RecordedScene scene) in Scenes(second))
        {
            int after = Array.FindIndex(before, moment => moment.Seconds - start >= seconds - 1e-6);
            if (after <= 0)
            {
                continue;
            }

            double part = (seconds - before[after - 1].Seconds + start) / (before[after].Seconds - before[after - 1].Seconds);
            var later = before[after].Scene.Snapshot.Entities.ToDictionary(entity => entity.Handle);
            EntityState[] replayed = [.. scene.Snapshot.Entities.Where(IsCompared)];
            EntityState[] recorded =
            [
                .. before[after - 1].Scene.Snapshot.Entities.Where(entity => IsCompared(entity) && later.ContainsKey(entity.Handle)),
            ];
            foreach (EntityState entity in recorded.Where(entity => (entity.Pose.Position - scene.Snapshot.Ego.Pose.Position).Length < 60))
            {
                Vector3D expected = (Middle(entity) * (1 - part)) + (Middle(later[entity.Handle]) * part);
                EntityState found = replayed.MinBy(other => Ground(Middle(other) - expected))!;
                Assert.InRange(Ground(Middle(found) - expected), 0, OnPath);
                Assert.InRange(Math.Abs((Middle(found) - expected).Z), 0, entity.Class == ObjectClass.Pedestrian ? BesideRoad : OnRoad);
                Assert.InRange((found.ModelMax - found.ModelMin - entity.ModelMax + entity.ModelMin).Length, 0, 0.002);
                double turn = Difference(Heading(later[entity.Handle]), Heading(entity));
                Assert.True(HasTurned(Heading(found) - Heading(entity), part, turn), $"{entity.Model}, {seconds} s");
                compared++;
            }
        }

        Assert.True(compared > 100, $"{compared}");
    }

    [Fact]
    public void Damaged_log_is_one_clear_line()
    {
        string file = _folder.PathOf("scenario.json");
        File.WriteAllText(file, "{\"scenario_id\": \"a\", \"objects\": [{}], \"roads\": []}");

        CliRun
            .Of("log", "import", file, "--out", _folder.PathOf("logs"))
            .AssertFailed(ExitCode.BadData, $"{file}: 'position' is missing or no list.");
        Assert.False(Directory.Exists(_folder.PathOf("logs")));
    }

    [Fact]
    public void Options_about_traffic_contradict_a_log() =>
        CliRun
            .Of("harvest", "--log", _folder.PathOf("none"), "--traffic", "2", "--out", _folder.PathOf("out"))
            .AssertFailed(ExitCode.Usage, "--traffic cannot be used with --log, which has its own roads and traffic.");

    /// <summary>Whether a heading has turned by a part of a turn; a half turn may go either way, which rounding decides.</summary>
    private static bool HasTurned(double turned, double part, double turn) =>
        Math.Abs(Difference(turned, part * turn)) <= Turn
        || (Math.PI - Math.Abs(turn) < Turn && Math.Abs(Difference(turned, -part * turn)) <= Turn);

    private static double Difference(double heading, double other) => Math.IEEERemainder(heading - other, 2 * Math.PI);

    private static bool IsCompared(EntityState entity) =>
        entity.Class is ObjectClass.Car or ObjectClass.Truck or ObjectClass.Bus or ObjectClass.Pedestrian;

    private static (double Seconds, RecordedScene Scene)[] Scenes(string folder)
    {
        var session = new SessionReader(folder);
        return
        [
            .. session
                .ReadLabels()
                .Select(label => (label.TimeSeconds, SceneParser.Read(session.PathOf(FramePaths.Scene(label.Frame)), label))),
        ];
    }

    private static Vector3D Middle(EntityState entity) => entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5);

    private static double Heading(EntityState entity) => Math.Atan2(entity.Pose.Axes.Forward.Y, entity.Pose.Axes.Forward.X);

    private static double Ground(Vector3D vector) => new Vector2D(vector.X, vector.Y).Length;
}
