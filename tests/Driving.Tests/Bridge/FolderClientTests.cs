using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>Clients of a shared folder that die, start again or think long. The player's time is the test's.</summary>
public sealed class FolderClientTests : IDisposable
{
    private const double Patience = FolderBridge.DefaultPatienceSeconds * 1000;
    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-client").FullName;
    private readonly FakeGame _game = new();
    private readonly FakeCar _car = new();
    private readonly TestClock _clock = new();
    private readonly FolderBridge _bridge;
    private readonly DrivingSession _session;
    private int _blanks;
    private long _frames = 1_000_000;

    public FolderClientTests()
    {
        DrivingOptions options = new() { SettleTicks = 0, Picture = Frames.Size };
        _bridge = new FolderBridge(_folder, Frames.Size, FolderBridge.DefaultPatienceSeconds, _clock);
        _session = new DrivingSession(options, _game.Ports with { Car = _car }, _bridge, () => new DeepDrivingController());
    }

    [Fact]
    public void World_resumes_without_pending_steps_when_a_client_dies()
    {
        for (int life = 0; life < 100; life++)
        {
            LeaveOutstanding(life);

            // Every other life is followed by one that says so; after the others there is nothing but silence.
            if (life % 2 == 0)
            {
                Command("""{"type":"hello"}""");
            }
            else
            {
                _clock.Milliseconds += Patience + 1;
            }

            Await(() => !_game.WantsFrozen && !_session.IsStepping, "the world to go on");
            Assert.Equal(DrivingControls.Stop, _session.Status.Controls);
            Assert.False(_session.Status.IsClientAlive);
            for (int tick = 0; tick < 30; tick++)
            {
                _session.Tick();
                _game.Tick();
            }

            Assert.False(_game.WantsFrozen);
        }

        Assert.Empty(_car.Resets);
        Assert.False(_session.Status.IsOver, _session.Status.Ending);
    }

    [Theory]
    [InlineData("alive.txt", "")]
    [InlineData("controls.txt", "0 0 1\n")]
    [InlineData("controls.txt", "nonsense")]
    [InlineData("indicators.txt", "0\n")]
    [InlineData("command.json", """{"type":"requestFrame"}""")]
    public void Slow_client_stays_connected_by_any_sign_of_life(string name, string content)
    {
        Command("""{"type":"pause","paused":true}""");
        Assert.Equal(new PauseMessage(true), Frames.AwaitMessage(_bridge));
        for (int thought = 0; thought < 5; thought++)
        {
            _clock.Milliseconds += 0.9 * Patience;
            Drop(name, content);
            AwaitRead();
        }

        // If it had ever counted as gone, that message would come first.
        Command("""{"type":"step","seconds":1}""");
        ClientMessage? message;
        do
        {
            message = Frames.AwaitMessage(_bridge);
            Assert.IsNotType<ClientGoneMessage>(message);
        } while (message is not StepMessage);

        _clock.Milliseconds += Patience + 1;
        Frames.Await(() => _bridge.TryReceive(out message) && message is ClientGoneMessage, "that the client is gone");
        Frames.Await(() => _bridge.Problem?.Contains("30 s", StringComparison.Ordinal) == true, "the reason");
    }

    public void Dispose()
    {
        _session.Dispose();
        _bridge.Dispose();
        Directory.Delete(_folder, recursive: true);
    }

    /// <summary>A client for which the world stands, or a step of ten seconds goes on, with more commands behind it.</summary>
    private void LeaveOutstanding(int life)
    {
        double steering = 0.001 * (life + 1);
        Command("""{"type":"pause","paused":true}""");
        Await(() => _game.WantsFrozen, "the pause");
        if (life % 3 > 0)
        {
            Command("""{"type":"step","seconds":10}""");
            Await(() => _session.IsStepping, "the step");
        }

        Drop("controls.txt", FormattableString.Invariant($"{steering} 1 0 {life}\n"));
        Await(() => _session.Status.Controls.Steering == steering, $"the controls of life {life}");
        if (_session.IsStepping)
        {
            foreach (
                string command in new[]
                {
                    """{"type":"reset","position":[1,2,3],"headingDegrees":4}""",
                    """{"type":"pause","paused":true}""",
                }
            )
            {
                Command(command);
                AwaitRead();
            }
        }
    }

    private void Command(string json) => Drop("command.json", json);

    /// <summary>Waits until the bridge has looked at all files: it does so between any two frames.</summary>
    private void AwaitRead()
    {
        for (int frame = 0; frame < 2; frame++)
        {
            _bridge.Publish(Frames.State(++_frames), Frames.Picture(1));
            string picture = Path.Combine(_folder, FormattableString.Invariant($"frame_{_frames:00000000}.png"));
            Frames.Await(() => File.Exists(picture), picture);
        }
    }

    /// <summary>Ticks of the session alone: the game's time stands, so no step comes to its end by waiting.</summary>
    private void Await(Func<bool> done, string what) =>
        Frames.Await(
            () =>
            {
                _session.Tick();
                return done();
            },
            $"{what}; the bridge says: {_bridge.Problem}"
        );

    /// <summary>
    /// Writes a file by renaming, with another length than the version before, because file times are coarse on some systems.
    /// </summary>
    private void Drop(string name, string content)
    {
        string path = Path.Combine(_folder, name);
        string blanks = new(' ', ++_blanks % 1_000);
        File.WriteAllText(path + ".new", content.EndsWith('\n') ? content[..^1] + blanks + "\n" : content + blanks);
        File.Move(path + ".new", path, overwrite: true);
    }
}
