using System.Diagnostics.CodeAnalysis;
using System.Text.Json;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Driving.Session;
using Harvester.Sessions.Imaging;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>
/// How many ticks lie between the taking of a frame and the controls that answer it, whatever a thread, the network and the client take:
/// they are waited for here between two ticks. What they take the benchmark bridge-latency measures.
/// </summary>
public sealed class FrameToControlTests : IDisposable
{
    private readonly FakeGame _game = new();
    private readonly FakeCar _car = new();
    private readonly AwaitedBridge _bridge = new(
        new SocketBridge(SocketBridgeOptions.Loopback with { Port = 0 }, new DrivingOptions().Picture)
    );

    [Theory]
    [InlineData(0)]
    [InlineData(4)]
    public void Answer_that_arrives_by_the_next_tick_is_applied_in_it(int settleTicks)
    {
        const int ticks = 1_200;
        using var session = new DrivingSession(
            new DrivingOptions { SettleTicks = settleTicks },
            _game.Ports with
            {
                Car = _car,
            },
            _bridge,
            () => new DeepDrivingController()
        );
        using var client = new SocketClient(_bridge.EndPoint);
        client.Send("""{"type":"controls","steering":0,"throttle":0,"brake":0}""");
        _bridge.AwaitMessage();

        double answered = 0;
        for (int tick = 0; tick < ticks; tick++)
        {
            long before = session.Status.Frames;
            session.Tick();
            _game.Tick();
            Assert.Equal(answered, session.Status.Controls.Steering);
            if (session.Status.Frames > before)
            {
                // Six ticks a frame; each frame's answer is another steering.
                JsonElement frame = client.Receive().Header;
                Assert.Equal(before, frame.GetProperty("frame").GetInt64());
                answered = ((before % 1_000) + 1) / 1_000.0;
                client.Send(
                    FormattableString.Invariant(
                        $$"""{"type":"controls","steering":{{answered}},"throttle":0,"brake":0,"frame":{{before}}}"""
                    )
                );
                _bridge.AwaitMessage();
            }
        }

        Assert.Equal(ticks / 6, session.Status.Frames);
    }

    public void Dispose() => _bridge.Dispose();

    /// <summary>A bridge whose next message can be waited for before the game asks for it.</summary>
    private sealed class AwaitedBridge(SocketBridge bridge) : IDrivingBridge, IClientInbox, IFrameOutbox
    {
        private readonly Queue<ClientMessage> _there = new();

        public System.Net.IPEndPoint EndPoint => bridge.EndPoint;

        public string? Problem => bridge.Problem;

        public string? Client => bridge.Client;

        public void AwaitMessage() => _there.Enqueue(Frames.AwaitMessage(bridge));

        public IClientInbox Inbox => this;

        public IFrameOutbox Outbox => this;

        public bool HasClientGone => bridge.Inbox.HasClientGone;

        public bool IsFrameAwaited => bridge.Outbox.IsFrameAwaited;

        public bool Publish(BridgeState state, PixelBuffer picture) => bridge.Publish(state, picture);

        public bool TryReceive([NotNullWhen(true)] out ClientMessage? message) => _there.TryDequeue(out message);

        public void Dispose() => bridge.Dispose();
    }
}
