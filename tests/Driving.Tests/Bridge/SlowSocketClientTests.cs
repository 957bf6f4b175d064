using Harvester.Driving.Bridge;
using Harvester.Driving.Session;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>
/// Clients that are slower than the frames, which are noise, so that no network keeps many of them: 280 x 210 x 3 bytes each.
/// </summary>
public sealed class SlowSocketClientTests : IDisposable
{
    private const int PublishedPerFrameRead = 5;
    private readonly PixelBuffer _noise = new(new DrivingOptions().Picture);
    private readonly SocketBridge _bridge;
    private long _published = -1;

    public SlowSocketClientTests()
    {
        new Random(7).NextBytes(_noise.Bytes);
        _bridge = Bridge(TimeSpan.FromMinutes(1));
    }

    [Theory]
    [InlineData("""{"type":"controls","steering":0,"throttle":0,"brake":0,"frame":FRAME}""")]
    [InlineData("""{"type":"controls","steering":0,"throttle":0,"brake":0}""")]
    [InlineData("""{"type":"indicators","values":[0,-7,3.5,7,75,75,-9.5,-1.6,2.4,5.5,75,30,40],"frame":FRAME}""")]
    [InlineData("""{"type":"pause","paused":false}""")]
    public void Slow_client_never_reads_a_frame_older_than_its_last_answer(string answer)
    {
        using SocketClient client = Connected();
        for (int round = 0; round < 20; round++)
        {
            long newestAtAnswer = _published;
            for (int i = 0; i < PublishedPerFrameRead; i++)
            {
                Publish();

                // Gives a bridge that sends whatever it can the time to do so; one that does not may be as slow or fast as it likes.
                Thread.Sleep(10);
            }

            long read = client.Receive().Header.GetProperty("frame").GetInt64();
            Assert.True(read >= newestAtAnswer, $"Frame {read} was sent after the answer, when there was frame {newestAtAnswer}.");
            client.Send(answer.Replace("FRAME", $"{read}", StringComparison.Ordinal));
            Assert.True(Frames.AwaitMessage(_bridge) is not ClientGoneMessage, _bridge.Problem);
        }
    }

    [Fact]
    public void Passive_client_gets_one_frame_and_one_per_request()
    {
        using SocketClient client = Connected();
        Publish();
        Assert.Equal(0, client.Receive().Header.GetProperty("frame").GetInt64());
        for (int round = 1; round <= 10; round++)
        {
            Publish();
            Publish();
            client.Send("""{"type":"requestFrame"}""");
            Assert.IsType<RequestFrameMessage>(Frames.AwaitMessage(_bridge));
            Publish(isAskedFor: true);
            Assert.Equal(3 * round, client.Receive().Header.GetProperty("frame").GetInt64());
        }
    }

    [Fact]
    public void Requested_frame_follows_one_that_was_not_answered()
    {
        using SocketClient client = Connected();
        Publish();
        Assert.Equal(0, client.Receive().Header.GetProperty("frame").GetInt64());
        Publish();
        Publish(isAskedFor: true);

        Assert.Equal(2, client.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Next_client_gets_no_frame_of_its_predecessor()
    {
        using SocketClient first = Connected();
        Publish();
        Publish();
        Publish();
        using SocketClient second = Connected();
        Publish();

        Assert.Equal(3, second.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Client_that_requests_frames_but_reads_none_is_cut_off()
    {
        using SocketBridge bridge = Bridge(TimeSpan.FromSeconds(1));
        using SocketClient sleeper = Connected(bridge);
        Frames.Await(
            () =>
            {
                bridge.Publish(Frames.State(++_published) with { IsAskedFor = true }, _noise);
                return bridge.Problem is not null;
            },
            "the sleeper to be cut off"
        );

        Assert.Contains("did not receive a frame", bridge.Problem, StringComparison.Ordinal);
        using SocketClient next = Connected(bridge);

        // The network keeps a black picture, and the bridge need not wait for this client to read it.
        bridge.Publish(Frames.State(++_published), new PixelBuffer(_noise.Size));
        Assert.Equal(_published, next.Receive().Header.GetProperty("frame").GetInt64());
    }

    [Fact]
    public void Frame_in_transit_when_the_bridge_closes_arrives_complete()
    {
        // Of so large a picture the network keeps a part only.
        PixelBuffer large = new(new ImageSize(1000, 1000));
        new Random(8).NextBytes(large.Bytes);
        using SocketBridge bridge = new(SocketBridgeOptions.Loopback with { Port = 0, SendPatience = TimeSpan.FromMinutes(1) }, large.Size);
        using SocketClient client = Connected(bridge);
        bridge.Publish(Frames.State(1), large);
        Frames.Await(() => client.Stream.DataAvailable, "the beginning of the frame");
        var ending = new Thread(bridge.Dispose);
        ending.Start();
        Frames.Await(() => ending.ThreadState is ThreadState.WaitSleepJoin or ThreadState.Stopped, "the bridge to wait for the client");

        Assert.Equal(1, client.Receive().Header.GetProperty("frame").GetInt64());
        Assert.True(client.IsCutOff());
        ending.Join();
    }

    public void Dispose() => _bridge.Dispose();

    private SocketBridge Bridge(TimeSpan sendPatience) =>
        new(SocketBridgeOptions.Loopback with { Port = 0, SendPatience = sendPatience }, _noise.Size);

    private SocketClient Connected() => Connected(_bridge);

    private static SocketClient Connected(SocketBridge bridge)
    {
        var client = new SocketClient(bridge.EndPoint);
        Assert.Equal("hello", client.ReceiveAny().Header.GetProperty("type").GetString());
        client.Send("""{"type":"requestFrame"}""");
        Assert.IsType<RequestFrameMessage>(Frames.AwaitWord(bridge));
        return client;
    }

    private void Publish(bool isAskedFor = false) => _bridge.Publish(Frames.State(++_published) with { IsAskedFor = isAskedFor }, _noise);
}
