using Harvester.Driving.Bridge;
using Harvester.Sessions.Imaging;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class FrameOutboxTests
{
    private readonly FrameOutbox _outbox = new(Frames.Size);

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
        _outbox.TryTake(TimeSpan.Zero, static _ => true, out _, out PixelBuffer picture);
        Put(2);
        Put(3);

        Assert.All(picture.Bytes, shade => Assert.Equal(1, shade));
    }

    [Fact]
    public void Withheld_frame_is_replaced_by_the_newer_one()
    {
        Put(1);
        Assert.False(_outbox.TryTake(TimeSpan.Zero, static _ => false, out _, out _));
        Put(2);
        var asked = new HashSet<long>();
        Assert.False(_outbox.TryTake(TimeSpan.Zero, state => asked.Add(state.Frame) && state.Frame < 0, out _, out _));

        Assert.Equal([2L], asked);
        Assert.Equal((2L, (byte)2), Take());
    }

    [Fact]
    public void Frame_that_replaces_a_requested_one_counts_as_requested()
    {
        _outbox.Put(Frames.State(1) with { IsAskedFor = true }, Frames.Picture(1), static () => false);
        Put(2);
        Assert.True(_outbox.TryTake(TimeSpan.Zero, static state => state.IsAskedFor, out BridgeState? second, out _));
        Put(3);

        Assert.Equal(2, second.Frame);
        Assert.False(_outbox.TryTake(TimeSpan.Zero, static state => state.IsAskedFor, out _, out _));
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

    private void Put(byte frame) => _outbox.Put(Frames.State(frame), Frames.Picture(frame), static () => false);

    private (long Frame, byte Shade)? Take() =>
        _outbox.TryTake(TimeSpan.Zero, static _ => true, out BridgeState? state, out PixelBuffer picture)
            ? (state.Frame, picture.Bytes[0])
            : null;
}
