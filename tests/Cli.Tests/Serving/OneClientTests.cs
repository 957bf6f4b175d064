using System.Net;
using Harvester.Driving.Bridge;
using Harvester.Geometry.Cameras;
using Harvester.Runs.Serving;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Serving;

public sealed class OneClientTests : IDisposable
{
    private static readonly TimeSpan Deadline = TimeSpan.FromSeconds(30);

    private readonly SocketBridge _bridge = new(new SocketBridgeOptions(IPAddress.Loopback, 0, null), new ImageSize(32, 24));
    private readonly OneClient _client;

    public OneClientTests() => _client = new OneClient(_bridge);

    public void Dispose() => _bridge.Dispose();

    [Fact]
    public void Client_that_left_before_anyone_looked_is_gone()
    {
        Assert.False(_client.IsGone());
        new SocketClient(_bridge.EndPoint).Dispose();
        Assert.True(SpinWait.SpinUntil(() => _bridge.ClientsGone > 0, Deadline));

        Assert.True(_client.IsGone());
    }

    [Fact]
    public void Game_goes_on_while_a_newer_client_is_there()
    {
        using SocketClient first = new(_bridge.EndPoint);
        Assert.True(SpinWait.SpinUntil(() => _bridge.Client is not null, Deadline));
        using SocketClient second = new(_bridge.EndPoint);
        Assert.True(SpinWait.SpinUntil(() => _bridge.ClientsGone > 0, Deadline));

        Assert.False(_client.IsGone());
    }
}
