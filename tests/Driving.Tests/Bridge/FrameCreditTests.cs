using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.TestSupport;

namespace Harvester.Driving.Tests.Bridge;

public sealed class FrameCreditTests
{
    private readonly FrameCredit _credit = new();

    [Fact]
    public void Only_one_frame_is_sent_without_an_answer()
    {
        Assert.True(_credit.TrySpend(Frames.State(1)));
        Assert.False(_credit.TrySpend(Frames.State(2)));
    }

    [Theory]
    [InlineData(4L, false)]
    [InlineData(5L, true)]
    [InlineData(6L, true)]
    [InlineData(null, true)]
    public void Controls_answer_the_frame_they_name_or_all_if_they_name_none(long? named, bool isAnswered)
    {
        _credit.TrySpend(Frames.State(5));
        _credit.Receive(new ControlsMessage(DrivingControls.Stop, named));

        Assert.Equal(isAnswered, _credit.TrySpend(Frames.State(7)));
    }

    [Theory]
    [InlineData(4L, false)]
    [InlineData(5L, true)]
    [InlineData(null, true)]
    public void Indicators_answer_a_frame_like_controls(long? named, bool isAnswered)
    {
        _credit.TrySpend(Frames.State(5));
        _credit.Receive(new IndicatorsMessage(new double[13], named));

        Assert.Equal(isAnswered, _credit.TrySpend(Frames.State(7)));
    }

    [Fact]
    public void Late_answer_to_an_earlier_frame_removes_no_credit()
    {
        _credit.TrySpend(Frames.State(5));
        _credit.Receive(new PauseMessage(false));
        _credit.Receive(new ControlsMessage(DrivingControls.Stop, 4));

        Assert.True(_credit.TrySpend(Frames.State(6)));
    }

    [Fact]
    public void Step_and_request_grant_no_further_frame()
    {
        _credit.TrySpend(Frames.State(5));
        _credit.Receive(new RequestFrameMessage());
        _credit.Receive(new StepMessage(1));

        Assert.False(_credit.TrySpend(Frames.State(6)));
    }

    [Fact]
    public void Requested_frame_is_always_sent_and_needs_no_answer()
    {
        _credit.TrySpend(Frames.State(5));
        Assert.True(_credit.TrySpend(Frames.State(6) with { IsAskedFor = true }));
        Assert.False(_credit.TrySpend(Frames.State(7)));
        _credit.Receive(new ControlsMessage(DrivingControls.Stop, 5));

        Assert.True(_credit.TrySpend(Frames.State(7)));
    }
}
