using System.Diagnostics;
using System.Globalization;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>Clients of a shared folder that are processes, and are killed in the middle of whatever they do just then.</summary>
public sealed class KilledClientTests : IDisposable
{
    private const int Lives = 100;
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-killed").FullName;

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Folder_survives_a_client_killed_and_restarted_100_times()
    {
        using var bridge = new FolderBridge(_folder, Frames.Size);
        var random = new Random(9);
        for (int life = 1; life <= Lives; life++)
        {
            // Every other time it does not rename its file into place.
            using Process client = Start(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"echo '0.25 0.5 0 {life}' > part; mv part controls.txt; printf '0.25 ' > controls.txt; echo '0.5 0 {life}' >> "
                        + $"controls.txt"
                )
            );
            AwaitWordOf(bridge, life);
            bridge.Publish(Frames.State(life), Frames.Picture((byte)life));
            Kill(client, random);
        }

        string last = Path.Combine(_folder, "frame_00000100.png");
        Frames.Await(() => File.Exists(last), last);
    }

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void World_resumes_when_a_lock_step_client_is_killed()
    {
        var game = new FakeGame();
        var clock = new TestClock();
        using var bridge = new FolderBridge(_folder, Frames.Size, FolderBridge.DefaultPatienceSeconds, clock);
        using var session = new DrivingSession(
            new DrivingOptions { SettleTicks = 0, Picture = Frames.Size },
            game.Ports with
            {
                Car = new FakeCar(),
            },
            bridge,
            () => new DeepDrivingController()
        );
        var random = new Random(10);
        for (int life = 1; life <= Lives; life++)
        {
            double steering = 0.001 * life;
            using Process client = Start(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $$"""
                    n=$((n+1))
                    echo '{{steering}} 1 0' > part; mv part controls.txt
                    echo '{"type":"pause","paused":true}' > part; mv part command.json
                    echo '{"type":"step","seconds":4.'$n'}' > part; mv part command.json
                    """
                )
            );
            Await(
                () => session.Status.Controls.Steering == steering && (game.WantsFrozen || session.IsStepping),
                $"the word of life {life}"
            );
            Kill(client, random);

            // What it wrote last may be read after this, and is a sign of life.
            Await(
                () =>
                {
                    clock.Milliseconds += (FolderBridge.DefaultPatienceSeconds * 1000) + 1;
                    return !game.WantsFrozen && !session.IsStepping && session.Status.Controls == DrivingControls.Stop;
                },
                "the world to go on"
            );
        }

        Assert.False(session.Status.IsOver, session.Status.Ending);

        void Await(Func<bool> done, string what) =>
            Frames.Await(
                () =>
                {
                    session.Tick();
                    game.Tick();
                    return done();
                },
                $"{what}; the bridge says: {bridge.Problem}"
            );
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static void Kill(Process client, Random random)
    {
        Thread.Sleep(random.Next(5));
        client.Kill(entireProcessTree: true);
        client.WaitForExit();
    }

    private static void AwaitWordOf(FolderBridge bridge, int life)
    {
        Frames.Await(
            () =>
            {
                while (bridge.TryReceive(out ClientMessage? message))
                {
                    if (message == new ControlsMessage(new DrivingControls(0.25, 0.5, 0), life))
                    {
                        return true;
                    }
                }

                return false;
            },
            $"a word of life {life}; the bridge says: {bridge.Problem}"
        );
    }

    /// <summary>A client that does the same without end.</summary>
    private Process Start(string deeds)
    {
        var start = new ProcessStartInfo("/bin/sh") { WorkingDirectory = _folder, RedirectStandardError = true };
        start.ArgumentList.Add("-c");
        start.ArgumentList.Add($"while :; do\n{deeds}\ndone");
        return Process.Start(start)!;
    }
}
