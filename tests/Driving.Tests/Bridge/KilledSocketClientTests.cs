using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>A complete drive over a socket whose clients die or are replaced while the world is paused or stepping for them.</summary>
public sealed class KilledSocketClientTests : IDisposable
{
    private readonly FakeGame _game = new();
    private readonly FakeCar _car = new();
    private readonly SocketBridge _bridge = new(SocketBridgeOptions.Loopback with { Port = 0 }, new DrivingOptions().Picture);
    private readonly DrivingSession _session;

    public KilledSocketClientTests() =>
        _session = new DrivingSession(
            new DrivingOptions { SettleTicks = 0 },
            _game.Ports with
            {
                Car = _car,
            },
            _bridge,
            () => new DeepDrivingController()
        );

    [Fact]
    public void World_resumes_without_pending_steps_when_a_client_dies()
    {
        for (int life = 0; life < 100; life++)
        {
            using SocketClient client = Outstanding(life);
            if (life % 2 == 0)
            {
                client.Kill();
            }
            else
            {
                client.Dispose();
            }

            Await(() => !_game.WantsFrozen && !_session.IsStepping, "the world to go on");
            Assert.Equal(DrivingControls.Stop, _session.Status.Controls);
            Assert.False(_session.Status.IsClientAlive);
            Run(30);
            Assert.False(_game.WantsFrozen);
        }

        Assert.Empty(_car.Resets);
        Assert.False(_session.Status.IsOver, _session.Status.Ending);
    }

    [Fact]
    public void Commands_of_a_replaced_lock_step_client_are_never_executed()
    {
        SocketClient client = Outstanding(0);
        for (int life = 1; life < 100; life++)
        {
            SocketClient next = Outstanding(life);
            client.Dispose();
            client = next;
        }

        client.Dispose();
        Await(() => !_game.WantsFrozen && !_session.IsStepping, "the world to go on");
        Assert.Empty(_car.Resets);
        Assert.False(_session.Status.IsOver, _session.Status.Ending);
    }

    public void Dispose()
    {
        _session.Dispose();
        _bridge.Dispose();
    }

    /// <summary>
    /// A client that is heard, for which a step of ten seconds goes on or the world stands, and that has said more than is taken.
    /// </summary>
    private SocketClient Outstanding(int life)
    {
        // A life's controls are known by their steering.
        double steering = 0.001 * (life + 1);
        var client = new SocketClient(_bridge.EndPoint);
        client.Send("""{"type":"pause","paused":true}""");
        if (life % 3 > 0)
        {
            client.Send("""{"type":"step","seconds":10}""");
            client.Send("""{"type":"step","seconds":10}""");
        }

        client.Send(FormattableString.Invariant($$"""{"type":"controls","steering":{{steering}},"throttle":1,"brake":0}"""));
        Await(() => _session.Status.Controls.Steering == steering && _game.WantsFrozen != _session.IsStepping, $"the word of life {life}");
        if (_session.IsStepping)
        {
            client.Send("""{"type":"reset","position":[1,2,3],"headingDegrees":4}""");
            client.Send("""{"type":"pause","paused":true}""");
        }

        return client;
    }

    /// <summary>Ticks of the session alone: the game's time stands, so no step comes to its end by waiting.</summary>
    private void Await(Func<bool> done, string what) =>
        Frames.Await(
            () =>
            {
                _session.Tick();
                return done();
            },
            what
        );

    private void Run(int ticks)
    {
        for (int tick = 0; tick < ticks; tick++)
        {
            _session.Tick();
            _game.Tick();
        }
    }
}
