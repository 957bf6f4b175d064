using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>Who may drive over a socket: a client that has sent a hello of the game's version.</summary>
public sealed class SocketHelloTests
{
    private static readonly SocketBridgeOptions AnyPort = SocketBridgeOptions.Loopback with
    {
        Port = 0,
        HelloPatience = Timeout.InfiniteTimeSpan,
    };

    [Fact]
    public void Bare_connections_displace_nobody()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var driver = new SocketClient(bridge.EndPoint);
        driver.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);

        // As many as a scan of ports makes.
        SocketClient[] scans = [.. Enumerable.Range(0, 20).Select(_ => new SocketClient(bridge.EndPoint, hello: null))];
        Frames.Await(() => bridge.Pending == AnyPort.MaxPending, "the connections to be taken");
        bridge.Publish(Frames.State(3), Frames.Picture(3));

        Assert.Equal(3, driver.Receive().Header.GetProperty("frame").GetInt64());
        Assert.All(scans, scan => scan.Dispose());
        Frames.Await(() => bridge.Pending == 0, "the connections to be gone");
        driver.Send("""{"type":"pause","paused":true}""");
        Assert.Equal(new PauseMessage(true), Frames.AwaitMessage(bridge));
    }

    [Theory]
    [InlineData("""{"type":"pause","paused":true}""", "the first message must be a hello.")]
    [InlineData("""{"type":"hello"}""", "the hello names no version; the game speaks version 1 of the bridge.")]
    [InlineData("""{"type":"hello","version":2}""", "the client speaks version 2 of the bridge, the game version 1.")]
    [InlineData("""{"type":"hello","version":0.5}""", "the client speaks version 0.5 of the bridge, the game version 1.")]
    [InlineData("""{"type":"hello","version":"1"}""", "field version must be a number.")]
    public void Other_first_message_is_refused_and_displaces_nobody(string message, string reason)
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var driver = new SocketClient(bridge.EndPoint);
        driver.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);
        using var stranger = new SocketClient(bridge.EndPoint, message);

        Assert.Equal(reason, stranger.Receive().Header.GetProperty("reason").GetString());
        Assert.True(stranger.IsCutOff());
        bridge.Publish(Frames.State(3), Frames.Picture(3));
        Assert.Equal(3, driver.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Hello_is_answered_with_the_version_of_the_game()
    {
        using var bridge = new SocketBridge(AnyPort, Frames.Size);
        using var client = new SocketClient(bridge.EndPoint);

        Assert.Equal("""{"type":"hello","version":1}""", client.ReceiveAny().Header.GetRawText());
    }

    [Fact]
    public void Connection_without_a_hello_in_time_is_cut_off()
    {
        using var bridge = new SocketBridge(AnyPort with { HelloPatience = TimeSpan.FromMilliseconds(50) }, Frames.Size);
        using var silent = new SocketClient(bridge.EndPoint, hello: null);

        Assert.Equal("the first message must be a hello, sent in time.", silent.Receive().Header.GetProperty("reason").GetString());
        Assert.True(silent.IsCutOff());
    }
}
