using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>
/// Twice 5,000 frames of a game with every quirk at once, judged by the number of the state that each picture shows. The lag of the picture
/// and the ticks until a freeze takes differ from freeze to freeze; traffic stops and starts; entities vanish; the pause is lost; pictures
/// are refused.
/// </summary>
public sealed class ImageEqualsLabelTests
{
    private const int FramesWanted = 5_000;

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Step_with_any_quirk_keeps_only_frames_that_match_labels(bool cameraReportedLate)
    {
        var random = new Random(11);
        var game = new FakeGame { CameraReportedLate = cameraReportedLate };
        game.Entities = entities =>
            random.Next(100) == 0
                ? []
                :
                [
                    .. entities,
                    entities[0] with
                    {
                        Handle = 102,
                        Pose = entities[0].Pose with { Position = new Vector3D(-3, 30 + (Math.Max(0, game.State % 400 - 200) * 0.05), 1) },
                    },
                ];
        game.OnCall = call =>
        {
            if (call == "Freeze")
            {
                game.PictureLag = random.Next(4);
                game.FreezeDelay = random.Next(4);
                game.GrabAnswer = random.Next(50) == 0 ? GrabResult.Refused("covered") : GrabResult.Good;
                game.MetresPerTick = random.Next(5) == 0 ? 0 : 0.25;
            }
        };
        var sink = new MemorySink { KeepsFrames = false };
        int judged = 0;
        int wrong = 0;
        sink.OnFrame = frame =>
        {
            judged++;
            wrong += FakeGame.StateOf(frame.Picture) == FakeGame.StateAt(frame.Label.TimeSeconds) ? 0 : 1;
        };
        var options = new HarvestOptions
        {
            Image = new ImageSize(8, 6),
            MaxFrames = FramesWanted,

            // The car drives farther and farther away.
            RangeMetres = 1e6,
            OcclusionSamples = 1,
            ProbeLag = false,
            MinBoxAreaPixels = 0,
            MinBoxSidePixels = 0,
        };
        using var session = new HarvestSession(options, game.Ports, sink);
        for (int tick = 0; tick < 1_000_000 && !session.Step().IsOver; tick++)
        {
            // Now and then another script lets the game go on.
            if (random.Next(200) == 0)
            {
                game.Unfreeze();
            }

            game.Tick();
        }

        Assert.Null(session.Fault);
        Assert.Equal(FramesWanted, judged);
        Assert.Equal(0, wrong);

        // The quirks did bite: refusals, and worlds that changed between the two readings.
        Assert.True(session.Counters.Discards["covered"] > 50);
        Assert.True(session.Counters.Discards["objectsChanged"] > 25);
        Assert.True(session.Counters.SettleTicks.Count > 3);
    }
}
