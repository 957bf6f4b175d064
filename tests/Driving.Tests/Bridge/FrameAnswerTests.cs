using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

/// <summary>When a client is sent a frame: after it has answered the last one, or has asked for one.</summary>
public sealed class FrameAnswerTests
{
    private const string Client = "client";
    private const string Other = "other";
    private readonly ClientInbox<string> _inbox = new();
    private readonly FrameOutbox<string> _outbox;

    public FrameAnswerTests()
    {
        _inbox.Welcome(Client);
        _outbox = new FrameOutbox<string>(Frames.Size, _inbox, needsAnswers: true);
    }

    [Fact]
    public void Only_one_frame_is_sent_without_an_answer()
    {
        Assert.True(IsSent(1));
        Assert.False(IsSent(2));
    }

    [Theory]
    [InlineData(4L, false)]
    [InlineData(5L, true)]
    [InlineData(6L, true)]
    [InlineData(null, true)]
    public void Controls_answer_the_frame_they_name_or_all_if_they_name_none(long? named, bool isAnswered)
    {
        IsSent(5);
        _outbox.Answer(Client, new ControlsMessage(DrivingControls.Stop, named));

        Assert.Equal(isAnswered, _outbox.IsFrameAwaited);
        Assert.Equal(isAnswered, IsSent(7));
    }

    [Theory]
    [InlineData(4L, false)]
    [InlineData(5L, true)]
    [InlineData(null, true)]
    public void Indicators_answer_a_frame_like_controls(long? named, bool isAnswered)
    {
        IsSent(5);
        _outbox.Answer(Client, new IndicatorsMessage(new double[13], named));

        Assert.Equal(isAnswered, IsSent(7));
    }

    [Fact]
    public void Late_answer_to_an_earlier_frame_removes_no_credit()
    {
        IsSent(5);
        _outbox.Answer(Client, new PauseMessage(false));
        _outbox.Answer(Client, new ControlsMessage(DrivingControls.Stop, 4));

        Assert.True(IsSent(6));
    }

    [Fact]
    public void Step_and_request_grant_no_further_frame()
    {
        IsSent(5);
        _outbox.Answer(Client, new RequestFrameMessage());
        _outbox.Answer(Client, new StepMessage(1));

        Assert.False(IsSent(6));
    }

    [Fact]
    public void Requested_frame_is_always_sent_and_needs_no_answer()
    {
        IsSent(5);
        Assert.True(IsSent(6, isAskedFor: true));
        Assert.False(IsSent(7));
        _outbox.Answer(Client, new ControlsMessage(DrivingControls.Stop, 5));

        Assert.True(IsSent(7));
    }

    [Fact]
    public void Answer_of_an_earlier_client_counts_for_nobody()
    {
        _outbox.Clear(() => _inbox.Welcome(Other));
        Assert.IsType<ClientGoneMessage>(Taken());
        IsSent(5);
        _outbox.Answer(Client, new ControlsMessage(DrivingControls.Stop, null));
        Assert.False(IsSent(6));
        _outbox.Answer(Other, new ControlsMessage(DrivingControls.Stop, null));

        Assert.True(IsSent(6));
    }

    [Fact]
    public void New_client_need_not_answer_what_the_earlier_one_was_sent()
    {
        IsSent(5);
        Assert.False(IsSent(6));
        _outbox.Clear(() => _inbox.Welcome(Other));
        Assert.IsType<ClientGoneMessage>(Taken());

        Assert.True(IsSent(7));
    }

    [Fact]
    public void Without_a_client_frames_are_taken_for_nobody()
    {
        _inbox.Leave(Client);
        Assert.IsType<ClientGoneMessage>(Taken());
        for (byte frame = 1; frame <= 2; frame++)
        {
            _outbox.Publish(Frames.State(frame), Frames.Picture(frame));
            Assert.True(_outbox.TryTake(TimeSpan.Zero, out _, out _, out string? client));
            Assert.Null(client);
        }
    }

    private bool IsSent(byte frame, bool isAskedFor = false)
    {
        _outbox.Publish(Frames.State(frame) with { IsAskedFor = isAskedFor }, Frames.Picture(frame));
        return _outbox.TryTake(TimeSpan.Zero, out BridgeState? state, out _, out _) && state.Frame == frame;
    }

    private ClientMessage? Taken() => _inbox.TryReceive(out ClientMessage? message) ? message : null;
}
