using System.Net;
using System.Text;
using Harvester.Capture.Driving;
using Harvester.Capture.Driving.Bridge;

namespace Harvester.Capture.Tests.Driving.Bridge;

public sealed class SocketBridgeTests
{
    private static readonly SocketBridgeOptions AnyPort = SocketBridgeOptions.Loopback with { Port = 0 };

    [Fact]
    public void Peer_gets_frames_and_its_controls_arrive()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var peer = new SocketClient(bridge.EndPoint);
        peer.Send("""{"type":"requestFrame"}""");
        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));

        bridge.Publish(Frames.State(7), Frames.Picture(100));
        (System.Text.Json.JsonElement header, byte[] png) = peer.Receive();
        peer.Send("""{"type":"controls","steering":0.25,"throttle":0.5,"brake":0,"frame":7}""");

        Assert.Equal("frame", header.GetProperty("type").GetString());
        Assert.Equal(7, header.GetProperty("frame").GetInt64());
        Assert.Equal(12.5, header.GetProperty("speedMetresPerSecond").GetDouble());
        Assert.Equal(13, header.GetProperty("torcsEquivalent").GetArrayLength());
        Assert.Equal(-7, header.GetProperty("indicators")[1].GetDouble());
        Assert.Equal([0x89, (byte)'P', (byte)'N', (byte)'G'], png[..4]);
        Assert.Equal(new ControlsMessage(new DrivingControls(0.25, 0.5, 0), 7), Frames.AwaitMessage(bridge));
    }

    [Fact]
    public void Publish_without_a_reader_never_waits_and_the_newest_frame_wins()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        for (int frame = 0; frame < 1000; frame++)
        {
            bridge.Publish(Frames.State(frame), Frames.Picture((byte)frame));
        }

        using var peer = new SocketClient(bridge.EndPoint);
        peer.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);
        bridge.Publish(Frames.State(1000), Frames.Picture(1));

        Assert.InRange(peer.Receive().Header.GetProperty("frame").GetInt64(), 999, 1000);
    }

    [Fact]
    public void Newer_peer_takes_the_place_of_the_older()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var first = new SocketClient(bridge.EndPoint);
        first.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);

        using var second = new SocketClient(bridge.EndPoint);
        second.Send("""{"type":"pause","paused":true}""");

        Assert.Equal(new PauseMessage(true), Frames.AwaitMessage(bridge));
        Assert.True(first.IsCutOff());
    }

    [Theory]
    [InlineData("""{"type":"pause","paused":true}""")]
    [InlineData("""{"type":"step","seconds":1}""")]
    public void World_that_a_peer_has_stopped_goes_on_when_it_goes_away_or_another_comes(string stopping)
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using (var first = new SocketClient(bridge.EndPoint))
        {
            first.Send(stopping);
            Frames.AwaitMessage(bridge);
        }

        Assert.Equal(new PauseMessage(false), Frames.AwaitMessage(bridge));
        using var second = new SocketClient(bridge.EndPoint);
        second.Send(stopping);
        PeerMessage stopped = Frames.AwaitMessage(bridge);
        using var third = new SocketClient(bridge.EndPoint);
        Assert.Equal(new PauseMessage(false), Frames.AwaitMessage(bridge));
        third.Send(stopping);

        Assert.Equal(stopped, Frames.AwaitMessage(bridge));
        Assert.True(second.IsCutOff());
        Assert.False(bridge.TryReceive(out _));
    }

    [Fact]
    public void Peer_without_the_token_is_cut_off_and_does_not_displace_the_welcome_one()
    {
        using var bridge = new SocketBridge(AnyPort with { Token = "open sesame" }, Frames.Size);
        using var friend = new SocketClient(bridge.EndPoint);
        friend.Send("""{"type":"hello","token":"open sesame"}""");
        friend.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);

        using var stranger = new SocketClient(bridge.EndPoint);
        stranger.Send("""{"type":"hello","token":"open"}""");

        Assert.Equal("error", stranger.Receive().Header.GetProperty("type").GetString());
        Assert.True(stranger.IsCutOff());
        bridge.Publish(Frames.State(3), Frames.Picture(3));
        Assert.Equal(3, friend.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Listening_where_others_can_reach_needs_a_token() =>
        Assert.Throws<ArgumentException>(() => new SocketBridge(new SocketBridgeOptions(IPAddress.Any, 0, null), Frames.Size));

    [Theory]
    [InlineData("{")]
    [InlineData("[]")]
    [InlineData("""{"type":"fly"}""")]
    [InlineData("""{"type":"controls","steering":"left","throttle":0,"brake":0}""")]
    [InlineData("""{"type":"controls","steering":1e999,"throttle":0,"brake":0}""")]
    [InlineData("""{"type":"step","seconds":-1}""")]
    [InlineData("""{"type":"reset","position":[1,2],"headingDegrees":0}""")]
    [InlineData("""{"type":"environment","timeOfDay":"25:00"}""")]
    public void Peer_that_sends_nonsense_is_told_and_cut_off_and_the_next_is_served(string nonsense)
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using (var peer = new SocketClient(bridge.EndPoint))
        {
            peer.Send(nonsense);
            Assert.Equal("error", peer.Receive().Header.GetProperty("type").GetString());
            Assert.True(peer.IsCutOff());
        }

        using var next = new SocketClient(bridge.EndPoint);
        next.Send("""{"type":"requestFrame"}""");

        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));
        Assert.NotNull(bridge.Problem);
    }

    [Fact]
    public void Peers_that_send_random_bytes_never_stop_the_bridge()
    {
        var random = new Random(11);
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        for (int i = 0; i < 100; i++)
        {
            using var peer = new SocketClient(bridge.EndPoint);
            byte[] bytes = new byte[random.Next(1, 300)];
            random.NextBytes(bytes);
            try
            {
                peer.Stream.Write(bytes);
            }
            catch (IOException)
            {
                // The bridge was quicker to cut this peer off than the peer to write.
            }

            bridge.Publish(Frames.State(i), Frames.Picture(1));
        }

        using var last = new SocketClient(bridge.EndPoint);
        last.Send("""{"type":"requestFrame"}""");

        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));
    }

    [Fact]
    public void Peer_that_never_reads_does_not_hold_up_the_game()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var sleeper = new SocketClient(bridge.EndPoint);
        sleeper.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);

        // Publish returns at once whatever the peer does; the newest frame reaches the next peer.
        for (int frame = 0; frame < 5000; frame++)
        {
            bridge.Publish(Frames.State(frame), Frames.Picture((byte)frame));
        }

        using var next = new SocketClient(bridge.EndPoint);
        next.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);
        bridge.Publish(Frames.State(6000), Frames.Picture(1));
        Assert.InRange(next.Receive().Header.GetProperty("frame").GetInt64(), 4999, 6000);
    }

    [Fact]
    public void Oversized_message_is_refused_before_it_is_read()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var peer = new SocketClient(bridge.EndPoint);

        peer.Stream.Write([0x7F, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0]);

        Assert.Contains("2147483647", peer.Receive().Header.GetProperty("reason").GetString()!, StringComparison.Ordinal);
    }

    [Fact]
    public void Parser_survives_mutated_messages()
    {
        var random = new Random(5);
        const string good = """{"type":"controls","steering":-0.25,"throttle":0.5,"brake":0.1,"frame":12}""";
        for (int i = 0; i < 20_000; i++)
        {
            var text = new StringBuilder(good);
            for (int change = random.Next(1, 5); change > 0; change--)
            {
                text[random.Next(text.Length)] = (char)random.Next(1, 128);
            }

            try
            {
                PeerMessageParser.Parse(text.ToString());
            }
            catch (BridgeException e)
            {
                Assert.NotEmpty(e.Message);
            }
        }
    }
}
