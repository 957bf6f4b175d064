using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>The frozen harvest against a game whose pictures tell which state they show.</summary>
public sealed class FrozenHarvestTests
{
    private static readonly HarvestOptions Small = new() { Image = new ImageSize(64, 48), MaxFrames = 25, OcclusionSamples = 4 };

    public static TheoryData<int, int> Quirks
    {
        get
        {
            var data = new TheoryData<int, int>();
            for (int lag = 0; lag <= 3; lag++)
            {
                for (int delay = 0; delay <= 3; delay++)
                {
                    data.Add(lag, delay);
                }
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Quirks))]
    public void Step_with_lagging_picture_keeps_only_frames_whose_picture_is_the_labels(int lag, int delay)
    {
        var game = new FakeGame { PictureLag = lag, FreezeDelay = delay };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small, game.Ports, sink);

        for (int tick = 0; tick < 1_000 && !session.Step().IsOver; tick++)
        {
            game.Tick();
        }

        Assert.Null(session.Fault);
        Assert.Equal(25, sink.Frames.Count);
        Assert.All(sink.Frames, frame =>
            Assert.Equal(FakeGame.StateOf(frame.Picture), (long)Math.Round(frame.Label.TimeSeconds * FakeGame.TicksPerSecond)));
        Assert.False(game.WantsFrozen);
    }
}
