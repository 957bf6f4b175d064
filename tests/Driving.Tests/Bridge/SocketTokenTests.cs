using System.Net;
using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>Which clients may drive over a socket that requires a token, and how long and how many others may wait.</summary>
public sealed class SocketTokenTests
{
    private const string Sesame = """{"type":"hello","version":1,"token":"open sesame"}""";
    private static readonly SocketBridgeOptions AnyPort = SocketBridgeOptions.Loopback with { Port = 0 };

    [Fact]
    public void Client_without_the_token_is_cut_off_and_displaces_nobody()
    {
        using var bridge = new SocketBridge(AnyPort with { Token = "open sesame", HelloPatience = Timeout.InfiniteTimeSpan }, Frames.Size);
        using var friend = new SocketClient(bridge.EndPoint, Sesame);
        friend.Send("""{"type":"requestFrame"}""");
        Frames.AwaitMessage(bridge);

        using var stranger = new SocketClient(bridge.EndPoint, """{"type":"hello","version":1,"token":"open"}""");

        Assert.Equal("error", stranger.Receive().Header.GetProperty("type").GetString());
        Assert.True(stranger.IsCutOff());
        bridge.Publish(Frames.State(3), Frames.Picture(3));
        Assert.Equal(3, friend.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Connections_without_the_token_are_limited_and_block_nobody()
    {
        // No connection times out here: one that is closed has made room for another.
        SocketBridgeOptions options = AnyPort with
        {
            Token = "open sesame",
            MaxPending = 4,
            HelloPatience = Timeout.InfiniteTimeSpan,
        };
        using var bridge = new SocketBridge(options, Frames.Size);
        SocketClient[] strangers = [.. Enumerable.Range(0, 40).Select(_ => new SocketClient(bridge.EndPoint, hello: null))];
        Assert.All(strangers.Take(36), stranger => Assert.True(stranger.IsCutOff()));
        Assert.Equal(4, bridge.Pending);

        using var friend = new SocketClient(bridge.EndPoint, Sesame);
        friend.Send("""{"type":"requestFrame"}""");
        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));

        // The friend had a place among them for a moment.
        Assert.True(strangers[36].IsCutOff());
        Assert.Equal(3, bridge.Pending);
        bridge.Dispose();
        Assert.All(strangers, stranger => Assert.True(stranger.IsCutOff()));
        Assert.All(strangers, stranger => stranger.Dispose());
    }

    [Fact]
    public void Connections_without_the_token_in_time_are_cut_off()
    {
        using var bridge = new SocketBridge(
            AnyPort with
            {
                Token = "open sesame",
                HelloPatience = TimeSpan.FromMilliseconds(50),
            },
            Frames.Size
        );
        using var silent = new SocketClient(bridge.EndPoint, hello: null);
        using var slow = new SocketClient(bridge.EndPoint, hello: null);
        slow.TryWrite([0, 0]);

        Assert.True(silent.IsCutOff());
        Assert.True(slow.IsCutOff());
        Frames.Await(() => bridge.Pending == 0, "the places of those who are cut off to be free");
    }

    [Fact]
    public void Empty_token_counts_as_no_token()
    {
        using var bridge = new SocketBridge(AnyPort with { Token = "" }, Frames.Size);
        using var client = new SocketClient(bridge.EndPoint);
        client.Send("""{"type":"requestFrame"}""");

        Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(bridge));
    }

    [Fact]
    public void Silent_client_is_told_that_a_token_is_required()
    {
        using var bridge = new SocketBridge(
            AnyPort with
            {
                Token = "open sesame",
                HelloPatience = TimeSpan.FromMilliseconds(50),
            },
            Frames.Size
        );
        using var stranger = new SocketClient(bridge.EndPoint, hello: null);

        Assert.Contains(
            "a hello with the right token",
            stranger.Receive().Header.GetProperty("reason").GetString(),
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Listening_on_a_public_interface_requires_a_token() =>
        Assert.Throws<ArgumentException>(() => new SocketBridge(new SocketBridgeOptions(IPAddress.Any, 0, null), Frames.Size));
}
