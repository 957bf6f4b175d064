using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>The motion of the ego between frames, of a game whose state is the number of ticks that it was not frozen.</summary>
public sealed class MotionTests
{
    private static readonly HarvestOptions Small = new()
    {
        Image = new ImageSize(64, 48),
        MaxFrames = 10,
        OcclusionSamples = 4,
        RateHz = 10,
        Motion = true,
    };

    [Theory]
    [InlineData(0)]
    [InlineData(2)]
    public void Frames_and_motion_have_each_tick_of_the_game_once(int freezeDelay)
    {
        var game = new FakeGame { FreezeDelay = freezeDelay };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small, game.Ports, sink);

        game.Run(session);

        long[] states =
        [
            .. sink
                .Frames.SelectMany(frame => frame.Label.Motion!.Select(sample => sample.TimeSeconds).Append(frame.Label.TimeSeconds))
                .Select(FakeGame.StateAt),
        ];
        Assert.Equal(Enumerable.Range(0, states.Length).Select(tick => states[0] + tick), states);

        // At 10 frames a second each frame has six ticks, the last of which is its own.
        Assert.Equal(5, sink.Frames[^1].Label.Motion!.Count);
        Assert.All(
            sink.Frames.SelectMany(frame => frame.Label.Motion!),
            sample => Assert.Equal(FakeGame.StateAt(sample.TimeSeconds) * game.MetresPerTick, sample.Pose.Position.Y)
        );
    }

    [Fact]
    public void Motion_of_discarded_frames_goes_to_the_next_one()
    {
        var game = new FakeGame();
        int grabs = 0;
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { ProbeLag = false, MaxFrames = 3 }, game.Ports, sink);
        game.OnCall = name => game.GrabAnswer = name == "Grab" && ++grabs == 2 ? GrabResult.Refused("covered") : GrabResult.Good;

        game.Run(session);

        // The second frame is taken a period later, after eleven ticks.
        Assert.Equal([0, 11, 5], sink.Frames.Select(frame => frame.Label.Motion!.Count));
    }

    [Fact]
    public void Motion_is_off_by_default()
    {
        var game = new FakeGame();
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { Motion = false }, game.Ports, sink);

        game.Run(session);

        Assert.All(sink.Frames, frame => Assert.Null(frame.Label.Motion));
        Assert.DoesNotContain("motion", JsonLabelWriter.Line(sink.Frames[0].Label), StringComparison.Ordinal);
    }
}
