using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;

namespace Harvester.Driving.Tests.Bridge;

public sealed class ClientInboxTests
{
    private const string First = "first";
    private const string Second = "second";
    private static readonly ClientMessage Stop = new ControlsMessage(DrivingControls.Stop, null);

    private readonly ClientInbox<string> _inbox = new();

    [Fact]
    public void Commands_keep_their_order_followed_by_the_newest_controls()
    {
        _inbox.Welcome(First);
        _inbox.TryPut(First, new StepMessage(1));
        _inbox.TryPut(First, new ControlsMessage(DrivingControls.Stop, 1));
        _inbox.TryPut(First, new StepMessage(2));
        _inbox.TryPut(First, new ControlsMessage(DrivingControls.Stop, 2));

        Assert.Equal([new StepMessage(1), new StepMessage(2), new ControlsMessage(DrivingControls.Stop, 2)], All());
    }

    [Fact]
    public void Messages_of_a_gone_client_are_dropped()
    {
        _inbox.Welcome(First);
        _inbox.TryPut(First, new PauseMessage(true));
        _inbox.TryPut(First, Stop);
        Assert.True(_inbox.Leave(First));
        Assert.True(_inbox.TryPut(First, new PauseMessage(true)));
        Assert.True(_inbox.TryPut(First, Stop));

        Assert.Equal([new ClientGoneMessage()], All());
        Assert.False(_inbox.Leave(First));
        Assert.Empty(All());
    }

    [Fact]
    public void Renewed_client_has_nothing_of_before()
    {
        _inbox.Welcome(First);
        _inbox.TryPut(First, new StepMessage(1));
        _inbox.Renew(First);
        Assert.True(_inbox.HasClientGone);
        _inbox.TryPut(First, new StepMessage(2));

        Assert.Equal([new ClientGoneMessage(), new StepMessage(2)], All());
        Assert.False(_inbox.HasClientGone);
        Assert.Equal(First, _inbox.Client);
    }

    [Fact]
    public void Messages_of_a_replaced_client_are_dropped()
    {
        _inbox.Welcome(First);
        _inbox.TryPut(First, new StepMessage(1));
        Assert.Equal(First, _inbox.Welcome(Second));
        _inbox.TryPut(First, new PauseMessage(true));
        _inbox.TryPut(Second, new StepMessage(2));
        _inbox.TryPut(First, Stop);
        Assert.False(_inbox.Leave(First));

        Assert.Equal([new ClientGoneMessage(), new StepMessage(2)], All());
    }

    [Fact]
    public void Full_inbox_still_reports_a_gone_client()
    {
        _inbox.Welcome(First);
        int room = 0;
        while (_inbox.TryPut(First, new PauseMessage(true)))
        {
            room++;
        }

        Assert.Equal(256, room);
        _inbox.Leave(First);

        Assert.Equal([new ClientGoneMessage()], All());
    }

    [Fact]
    public void Clients_that_come_and_go_between_reads_leave_once()
    {
        _inbox.Welcome(First);
        _inbox.Welcome(Second);
        _inbox.Leave(Second);
        _inbox.Welcome(First);
        _inbox.TryPut(First, new StepMessage(3));

        Assert.Equal([new ClientGoneMessage(), new StepMessage(3)], All());
    }

    [Fact]
    public void Each_client_that_left_or_was_replaced_is_counted()
    {
        Assert.Equal(0, _inbox.ClientsGone);
        _inbox.Welcome(First);
        _inbox.Welcome(Second);
        Assert.Equal(1, _inbox.ClientsGone);
        _inbox.Leave(First);
        _inbox.Leave(Second);
        Assert.Equal(2, _inbox.ClientsGone);
        _inbox.CountMissed();
        Assert.Equal(3, _inbox.ClientsGone);
    }

    [Fact]
    public void Welcoming_the_same_client_again_reports_nobody_gone()
    {
        Assert.Null(_inbox.Welcome(First));
        _inbox.TryPut(First, new StepMessage(1));
        Assert.Null(_inbox.Welcome(First));

        Assert.Equal(0, _inbox.ClientsGone);
        Assert.Equal([new StepMessage(1)], All());
    }

    [Fact]
    public void Closed_inbox_accepts_no_client()
    {
        _inbox.Welcome(First);
        Assert.Equal(First, _inbox.Close());
        Assert.Equal(Second, _inbox.Welcome(Second));
        Assert.Null(_inbox.Client);
    }

    [Fact]
    public void Replaced_clients_on_busy_threads_are_no_longer_heard()
    {
        const int clients = 4;
        const int rounds = 500;
        string[] names = [.. Enumerable.Range(0, clients).Select(i => $"client {i}")];
        bool isOver = false;
        Thread[] talking =
        [
            .. names.Select(
                (name, i) =>
                    new Thread(() =>
                    {
                        while (!Volatile.Read(ref isOver))
                        {
                            _inbox.TryPut(name, new StepMessage(i));
                            _inbox.TryPut(name, new ControlsMessage(DrivingControls.Stop, i));
                        }
                    })
                    {
                        IsBackground = true,
                    }
            ),
        ];
        Array.ForEach(talking, thread => thread.Start());

        var wrong = new List<ClientMessage>();
        _inbox.Welcome(names[0]);
        for (int round = 1; round < rounds; round++)
        {
            int now = round % clients;
            _inbox.Welcome(names[now]);
            Assert.True(_inbox.TryReceive(out ClientMessage? first));
            Assert.IsType<ClientGoneMessage>(first);
            for (int taken = 0; taken < 10 && _inbox.TryReceive(out ClientMessage? message); taken++)
            {
                bool isOfNow = message is StepMessage step ? step.Seconds == now : ((ControlsMessage)message).Frame == now;
                wrong.AddRange(isOfNow ? [] : [message]);
            }
        }

        Volatile.Write(ref isOver, true);
        Array.ForEach(talking, thread => thread.Join());
        Assert.Empty(wrong);
    }

    private List<ClientMessage> All()
    {
        var all = new List<ClientMessage>();
        while (_inbox.TryReceive(out ClientMessage? message))
        {
            all.Add(message);
        }

        return all;
    }
}
