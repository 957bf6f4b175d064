using Harvester.Driving.Bridge;

namespace Harvester.Driving.Tests.Bridge;

public sealed class WaitingRoomTests
{
    private readonly PendingClients<string> _room = new(2);

    [Fact]
    public void Longest_pending_connection_makes_room()
    {
        Assert.Null(_room.Enter("a"));
        Assert.Null(_room.Enter("b"));
        Assert.Equal("a", _room.Enter("c"));
        Assert.Equal("b", _room.Enter("d"));
        Assert.Equal(2, _room.Count);
    }

    [Fact]
    public void Each_pending_connection_leaves_once()
    {
        _room.Enter("a");
        _room.Enter("b");
        Assert.True(_room.TryLeave("a"));
        Assert.False(_room.TryLeave("a"));
        Assert.Null(_room.Enter("c"));
        Assert.Equal("b", _room.Enter("d"));
        Assert.False(_room.TryLeave("b"));
    }

    [Fact]
    public void Closed_pending_clients_accept_nobody()
    {
        _room.Enter("a");

        Assert.Equal(["a"], _room.Close());
        Assert.Equal("b", _room.Enter("b"));
        Assert.Equal(0, _room.Count);
    }
}
