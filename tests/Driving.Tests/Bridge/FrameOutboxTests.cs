using Harvester.Driving.Bridge;
using Harvester.Sessions.Imaging;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class FrameOutboxTests
{
    private const string Client = "client";
    private readonly ClientInbox<string> _inbox = new();
    private readonly FrameOutbox<string> _outbox;

    public FrameOutboxTests()
    {
        _inbox.Welcome(Client);
        _outbox = new FrameOutbox<string>(Frames.Size, _inbox, needsAnswers: true);
    }

    [Fact]
    public void Newer_of_two_frames_is_taken_with_its_picture()
    {
        Put(1);
        Put(2);

        Assert.Equal((2L, (byte)2), Take());
        Assert.Null(Take());
    }

    [Fact]
    public void Taken_picture_is_unchanged_by_newer_ones()
    {
        Put(1);
        _outbox.TryTake(TimeSpan.Zero, out _, out PixelBuffer picture, out _);
        Put(2);
        Put(3);

        Assert.All(picture.Bytes, shade => Assert.Equal(1, shade));
    }

    [Fact]
    public void Withheld_frame_is_replaced_by_the_newer_one()
    {
        Put(1);
        Assert.Equal((1L, (byte)1), Take());
        Put(2);
        Assert.Null(Take());
        Put(3);
        Assert.Null(Take());
        _outbox.Answer(Client, new PauseMessage(true));

        Assert.Equal((3L, (byte)3), Take());
    }

    [Fact]
    public void Frame_that_replaces_a_requested_one_counts_as_requested()
    {
        Put(0);
        Assert.NotNull(Take());
        _outbox.Publish(Frames.State(1) with { IsAskedFor = true }, Frames.Picture(1));
        Put(2);
        Assert.True(_outbox.TryTake(TimeSpan.Zero, out BridgeState? second, out _, out _));
        Put(3);

        Assert.Equal((2, true), (second.Frame, second.IsAskedFor));
        Assert.Null(Take());
    }

    [Fact]
    public void Cleared_or_closed_outbox_gives_nothing()
    {
        Put(1);
        _outbox.Clear(static () => { });
        Assert.Null(Take());
        Put(2);
        _outbox.Close();

        Assert.Null(Take());
    }

    private void Put(byte frame) => _outbox.Publish(Frames.State(frame), Frames.Picture(frame));

    private (long Frame, byte Shade)? Take() =>
        _outbox.TryTake(TimeSpan.Zero, out BridgeState? state, out PixelBuffer picture, out _) ? (state.Frame, picture.Bytes[0]) : null;
}
