using System.Diagnostics;
using System.Globalization;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>A complete drive over a shared folder in which another process is malicious or broken.</summary>
public sealed class FuzzedFolderTests : IDisposable
{
    private readonly string _parent = Directory.CreateTempSubdirectory("harvester-fuzzed").FullName;
    private readonly string _folder;
    private readonly FakeGame _game = new();
    private readonly FakeCar _car = new();

    public FuzzedFolderTests() => _folder = Path.Combine(_parent, "shared");

    [Theory]
    [InlineData(1, 250)]
    [InlineData(2, 250)]
    public void Drive_survives_random_changes_in_the_folder(int seed, int deeds) => Fuzz(seed, deeds);

    [Theory]
    [Trait("Category", "Heavy")]
    [InlineData(3, 2_000)]
    public void Drive_survives_many_random_changes_in_the_folder(int seed, int deeds) => Fuzz(seed, deeds);

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Disk_that_never_answers_blocks_neither_the_game_nor_its_end()
    {
        FolderBridge bridge = new(_folder, Frames.Size);
        using DrivingSession session = Session(bridge);

        // Opening a pipe for reading blocks until somebody opens it for writing: the bridge's thread hangs for good.
        using Process pipe = Process.Start("mkfifo", Path.Combine(_folder, "controls.txt"));
        pipe.WaitForExit();
        Assert.Equal(0, pipe.ExitCode);
        Run(session, 600);
        Assert.Equal(100, session.Status.Frames);

        var end = Task.Run(bridge.Dispose);
        Frames.Await(() => end.IsCompleted, "the bridge's end");
    }

    [PosixFact]
    public void Endless_file_is_not_read_for_ever()
    {
        using FolderBridge bridge = new(_folder, Frames.Size);
        File.CreateSymbolicLink(Path.Combine(_folder, "command.json"), "/dev/zero");
        Frames.Await(() => bridge.Problem?.Contains("device", StringComparison.Ordinal) == true, "the problem to be reported");
    }

    public void Dispose()
    {
        FolderVandal.Allow(_folder);
        Directory.Delete(_parent, recursive: true);
    }

    private void Fuzz(int seed, int deeds)
    {
        using FolderBridge bridge = new(_folder, Frames.Size);
        using DrivingSession session = Session(bridge);
        using FolderVandal vandal = new(_folder, seed);
        for (int deed = 1; deed <= deeds; deed++)
        {
            vandal.DoSomething();
            Run(session, 6);
            if (deed % 50 == 0)
            {
                vandal.Mend();
                Serve(session, bridge, 0.5 + (0.0001 * deed / 50));
            }
        }

        Assert.False(session.Status.IsOver, session.Status.Ending);
        Assert.All(
            _car.Driven,
            controls =>
                Assert.True(Math.Abs(controls.Steering) <= 1 && controls.Throttle is >= 0 and <= 1 && controls.Brake is >= 0 and <= 1)
        );

        // Ten that the bridge keeps; the vandal's own are none of them.
        Frames.Await(() => Directory.GetFiles(_folder, "frame_*.png").Length <= 10, "old pictures to go");
        Assert.InRange(Directory.GetFiles(_folder, "*.partial").Length, 0, 1);
    }

    /// <summary>A good client drives, and sees.</summary>
    private void Serve(DrivingSession session, FolderBridge bridge, double steering)
    {
        int words = 0;
        Frames.Await(
            () =>
            {
                if (session.Status.Controls.Steering == steering)
                {
                    return true;
                }

                // Repeated, as clients do: a step requested by another process may delay the world's time.
                string path = Path.Combine(_folder, "controls.txt");
                File.WriteAllText(path + ".new", FormattableString.Invariant($"{steering} 0 0 {++words}\n"));
                File.Move(path + ".new", path, overwrite: true);
                Run(session, 1);
                return false;
            },
            $"the good client to drive; the bridge says: {bridge.Problem}"
        );

        long frames = 0;
        Frames.Await(
            () =>
            {
                File.WriteAllText(Path.Combine(_folder, "command.json"), """{"type":"requestFrame"}""" + new string(' ', ++words % 100));
                Run(session, 1);
                string[] lines = File.Exists(Path.Combine(_folder, "state.txt"))
                    ? File.ReadAllLines(Path.Combine(_folder, "state.txt"))
                    : [];
                long seen = lines.Length == 2 ? long.Parse(lines[1].Split(' ')[0], CultureInfo.InvariantCulture) : 0;
                frames = frames == 0 ? session.Status.Frames : frames;
                return seen >= frames && session.Status.Frames > frames;
            },
            $"the good client to see; the bridge says: {bridge.Problem}"
        );
    }

    private DrivingSession Session(FolderBridge bridge) =>
        new(
            new DrivingOptions { SettleTicks = 0, Picture = Frames.Size },
            _game.Ports with
            {
                Car = _car,
            },
            bridge,
            () => new DeepDrivingController()
        );

    private void Run(DrivingSession session, int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            session.Tick();
            _game.Tick();
        }
    }
}
