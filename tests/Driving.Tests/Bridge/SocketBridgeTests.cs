using System.Text;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class SocketBridgeTests
{
    private static readonly SocketBridgeOptions AnyPort = SocketBridgeOptions.Loopback with { Port = 0 };

    [Fact]
    public void Client_gets_frames_and_its_controls_arrive()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var client = new SocketClient(bridge.EndPoint);
        client.Send("""{"type":"requestFrame"}""");
        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));

        bridge.Publish(Frames.State(7), Frames.Picture(100));
        (System.Text.Json.JsonElement header, byte[] png) = client.Receive();
        client.Send("""{"type":"controls","steering":0.25,"throttle":0.5,"brake":0,"frame":7}""");

        Assert.Equal("frame", header.GetProperty("type").GetString());
        Assert.Equal(7, header.GetProperty("frame").GetInt64());
        Assert.Equal(12.5, header.GetProperty("speedMetresPerSecond").GetDouble());
        Assert.Equal(13, header.GetProperty("torcsEquivalent").GetArrayLength());
        Assert.Equal(-7, header.GetProperty("indicators")[1].GetDouble());
        Assert.Equal([0x89, (byte)'P', (byte)'N', (byte)'G'], png[..4]);
        Assert.Equal(new ControlsMessage(new DrivingControls(0.25, 0.5, 0), 7), Frames.AwaitMessage(bridge));
    }

    [Fact]
    public void Publish_without_a_reader_never_blocks_and_the_newest_wins()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        for (int frame = 0; frame < 1000; frame++)
        {
            bridge.Publish(Frames.State(frame), Frames.Picture((byte)frame));
        }

        using var client = new SocketClient(bridge.EndPoint);
        client.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);
        bridge.Publish(Frames.State(1000), Frames.Picture(1));

        ReceiveUntil(client, 1000);
    }

    [Fact]
    public void Client_that_disconnects_leaves_only_a_gone_message()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using (var first = new SocketClient(bridge.EndPoint))
        {
            first.Send("""{"type":"requestFrame"}""");
            Frames.AwaitMessage(bridge);

            // More than there is room for.
            for (int i = 0; i < 300; i++)
            {
                first.Send("""{"type":"pause","paused":true}""");
            }

            Frames.Await(() => bridge.Problem is not null, "the box to be full");
        }

        // The last pauses may be under way still, and be taken before; after it none is.
        ClientMessage message = Frames.AwaitMessage(bridge);
        while (message is PauseMessage)
        {
            message = Frames.AwaitMessage(bridge);
        }

        Assert.IsType<ClientGoneMessage>(message);
        Assert.False(bridge.TryReceive(out _));
    }

    [Fact]
    public void Frame_made_for_a_replaced_client_is_not_sent_to_the_next()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var first = new SocketClient(bridge.EndPoint);
        first.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);
        using var second = new SocketClient(bridge.EndPoint);
        Frames.Await(() => bridge.Inbox.HasClientGone, "the second client");

        Assert.False(bridge.Publish(Frames.State(1) with { IsAskedFor = true }, Frames.Picture(1)));
        Assert.IsType<ClientGoneMessage>(Frames.AwaitMessage(bridge));
        Assert.True(bridge.Publish(Frames.State(2) with { IsAskedFor = true }, Frames.Picture(2)));

        Assert.Equal(2, second.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Frame_is_awaited_until_it_is_sent_and_after_its_answer()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        Assert.False(bridge.Outbox.IsFrameAwaited);
        using var client = new SocketClient(bridge.EndPoint);
        Frames.Await(() => bridge.Outbox.IsFrameAwaited, "a client");

        bridge.Publish(Frames.State(1), Frames.Picture(1));
        client.Receive();
        Assert.False(bridge.Outbox.IsFrameAwaited);

        client.Send("""{"type":"controls","steering":0,"throttle":0,"brake":0,"frame":1}""");
        Frames.AwaitMessage(bridge);
        Frames.Await(() => bridge.Outbox.IsFrameAwaited, "the answer to count");
    }

    [Fact]
    public void Newer_client_replaces_the_older()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var first = new SocketClient(bridge.EndPoint);
        first.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);
        using var second = new SocketClient(bridge.EndPoint);
        second.Send("""{"type":"pause","paused":true}""");
        Assert.True(first.IsCutOff());

        Assert.Equal(new ClientGoneMessage(), Frames.AwaitMessage(bridge));
        Assert.Equal(new PauseMessage(true), Frames.AwaitMessage(bridge));
    }

    [Theory]
    [InlineData("{")]
    [InlineData("[]")]
    [InlineData("""{"type":"fly"}""")]
    [InlineData("""{"type":"controls","steering":"left","throttle":0,"brake":0}""")]
    [InlineData("""{"type":"controls","steering":1e999,"throttle":0,"brake":0}""")]
    [InlineData("""{"type":"step","seconds":-1}""")]
    [InlineData("""{"type":"reset","position":[1,2],"headingDegrees":0}""")]
    [InlineData("""{"type":"reset","position":[1,2,3],"headingDegrees":1e300}""")]
    [InlineData("""{"type":"indicators","values":[0,0,0,0,0,0,0,0,0,0,0,0,1001]}""")]
    [InlineData("""{"type":"reset","position":[1,2,3],"headingDegrees":-360.5}""")]
    [InlineData("""{"type":"reset","position":[1e39,2,3],"headingDegrees":0}""")]
    [InlineData("""{"type":"environment","timeOfDay":"25:00"}""")]
    [InlineData("""{"type":"environment","weather":"hail"}""")]
    public void Client_that_sends_nonsense_gets_an_error_and_is_cut_off(string nonsense)
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using (var client = new SocketClient(bridge.EndPoint))
        {
            client.Send(nonsense);
            Assert.Equal("error", client.Receive().Header.GetProperty("type").GetString());
            Assert.NotNull(bridge.Problem);
            Assert.True(client.IsCutOff());
        }

        using var next = new SocketClient(bridge.EndPoint);
        next.Send("""{"type":"requestFrame"}""");

        Assert.IsType<RequestFrameMessage>(Frames.AwaitWord(bridge));
    }

    [Fact]
    public void Clients_that_send_random_bytes_never_stop_the_bridge()
    {
        var random = new Random(11);
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        for (int i = 0; i < 100; i++)
        {
            using var client = new SocketClient(bridge.EndPoint);
            byte[] bytes = new byte[random.Next(1, 300)];
            random.NextBytes(bytes);
            client.TryWrite(bytes);
            bridge.Publish(Frames.State(i), Frames.Picture(1));
        }

        using var last = new SocketClient(bridge.EndPoint);
        last.Send("""{"type":"requestFrame"}""");

        Assert.IsType<RequestFrameMessage>(Frames.AwaitWord(bridge));
    }

    [Fact]
    public void Client_that_never_reads_does_not_block_the_game()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var sleeper = new SocketClient(bridge.EndPoint);
        sleeper.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);

        // Publish returns at once whatever the client does; the newest frame reaches the next client.
        for (int frame = 0; frame < 5000; frame++)
        {
            bridge.Publish(Frames.State(frame), Frames.Picture((byte)frame));
        }

        using var next = new SocketClient(bridge.EndPoint);
        next.Send("""{"type":"requestFrame"}""");
        Frames.AwaitWord(bridge);
        bridge.Publish(Frames.State(6000), Frames.Picture(1));
        ReceiveUntil(next, 6000);
    }

    [Theory]
    [InlineData("type")]
    [InlineData("field")]
    public void Long_multiline_problem_is_reported_in_one_short_line(string where)
    {
        string text = "a\\nb\\r\\u2028\\u0000" + new string('x', 30_000);
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var client = new SocketClient(bridge.EndPoint);
        client.Send(where == "type" ? $"{{\"type\":\"{text}\"}}" : $"{{\"{text}\":1,\"{text}\":2}}");

        Assert.Contains("'a?b???xxx", client.Receive().Header.GetProperty("reason").GetString(), StringComparison.Ordinal);
        Assert.InRange(bridge.Problem!.Length, 1, 250);
        Assert.DoesNotContain(bridge.Problem, letter => char.IsControl(letter) || letter == '\u2028');
    }

    [Fact]
    public void Connection_that_ends_before_it_is_served_is_released()
    {
        using var nobody = new System.Net.Sockets.TcpClient();
        var inbox = new ClientInbox<BridgeClient>();

        Assert.ThrowsAny<Exception>(() =>
            BridgeClient.Serve(
                nobody,
                new SocketReception(
                    AnyPort,
                    inbox,
                    new PendingClients<BridgeClient>(1),
                    new FrameOutbox<BridgeClient>(Frames.Size, inbox, needsAnswers: true),
                    static _ => { }
                )
            )
        );
        Assert.Null(nobody.Client);
    }

    [Fact]
    public void Oversized_message_is_refused_before_it_is_read()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var client = new SocketClient(bridge.EndPoint);

        client.Stream.Write([0x7F, 0xFF, 0xFF, 0xFF, 0, 0, 0, 0]);

        Assert.Contains("2147483647", client.Receive().Header.GetProperty("reason").GetString()!, StringComparison.Ordinal);
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
                ClientMessageParser.Parse(text.ToString());
            }
            catch (BridgeException e)
            {
                Assert.NotEmpty(e.Message);
            }
        }
    }

    /// <summary>
    /// Frames in their order to one that must come; which of the earlier ones come depends on how fast the sender's thread is.
    /// </summary>
    private static void ReceiveUntil(SocketClient client, long wanted)
    {
        long last = -1;
        while (last < wanted)
        {
            long frame = client.Receive().Header.GetProperty("frame").GetInt64();
            Assert.InRange(frame, last + 1, wanted);
            last = frame;
        }
    }
}
