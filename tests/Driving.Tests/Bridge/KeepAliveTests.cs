using System.Net.Sockets;
using Harvester.Driving.Bridge;

namespace Harvester.Driving.Tests.Bridge;

public sealed class KeepAliveTests
{
    [Fact]
    public void Keep_alive_probes_after_five_seconds_and_five_times()
    {
        using var socket = new Socket(SocketType.Stream, ProtocolType.Tcp);

        KeepAlive.Ask(socket);

        Assert.NotEqual(0, socket.GetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive));
        Assert.Equal(5, socket.GetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveTime));
        Assert.Equal(1, socket.GetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveInterval));
        Assert.Equal(5, socket.GetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveRetryCount));
    }
}
