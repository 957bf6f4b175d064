using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>The live harvest: the game is never frozen after the lag is measured.</summary>
public sealed class LiveHarvestTests
{
    private static readonly HarvestOptions Live = new()
    {
        Image = new ImageSize(64, 48),
        MaxFrames = 50,
        OcclusionSamples = 4,
        Freeze = false,
    };

    public static TheoryData<int, bool> Quirks
    {
        get
        {
            var data = new TheoryData<int, bool>();
            for (int lag = 0; lag <= 3; lag++)
            {
                data.Add(lag, false);
                data.Add(lag, true);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Quirks))]
    public void Step_with_picture_lag_labels_the_state_in_the_picture(int lag, bool cameraLate)
    {
        var game = new FakeGame { PictureLag = lag, CameraReportedLate = cameraLate };
        var sink = new MemorySink();
        using var session = new HarvestSession(Live, game.Ports, sink);

        game.Run(session);

        Assert.Null(session.Fault);
        Assert.Equal(50, sink.Frames.Count);
        Assert.Equal(new PictureLag(cameraLate ? lag - 1 : lag, lag), session.Lag);
        Assert.All(
            sink.Frames,
            frame =>
            {
                long shown = FakeGame.StateOf(frame.Picture);
                Assert.Equal(shown, FakeGame.StateAt(frame.Label.TimeSeconds));
                Assert.Equal(shown * game.MetresPerTick, frame.Label.Camera.Pose.Position.Y);
                Assert.Equal(lag, frame.Label.LagFrames);
                Assert.Equal(lag / FakeGame.TicksPerSecond, frame.Label.LagSeconds, 9);
            }
        );
    }

    [Fact]
    public void Judge_detects_frames_with_a_wrong_given_lag()
    {
        // The control for the test above.
        var game = new FakeGame { PictureLag = 2 };
        var sink = new MemorySink();
        using var session = new HarvestSession(Live with { LiveLag = new PictureLag(1, 1) }, game.Ports, sink);

        game.RunAlone(10);
        game.Run(session);

        Assert.All(sink.Frames, frame => Assert.Equal(1, FakeGame.StateAt(frame.Label.TimeSeconds) - FakeGame.StateOf(frame.Picture)));
    }

    [Fact]
    public void Step_with_the_lag_given_never_freezes()
    {
        bool frozen = false;
        var game = new FakeGame { OnCall = call => frozen |= call == "Freeze" };
        var sink = new MemorySink();
        using var session = new HarvestSession(Live with { LiveLag = new PictureLag(0, 0) }, game.Ports, sink);

        game.Run(session);

        Assert.Equal(50, sink.Frames.Count);
        Assert.False(frozen);
    }

    [Fact]
    public void Step_in_a_standing_world_refuses_to_guess_the_lag()
    {
        var game = new FakeGame { MetresPerTick = 0 };
        using var session = new HarvestSession(Live, game.Ports, new MemorySink());

        game.Run(session);

        Assert.Equal(HarvestPhase.Faulted, session.Status.Phase);
        Assert.StartsWith("The picture lag could not be measured", session.Fault, StringComparison.Ordinal);
        Assert.False(game.WantsFrozen);
    }

    [Fact]
    public void Step_measures_the_lag_in_a_flickering_world()
    {
        // The last byte of each picture is noise; the movement in the first ones is larger than three times that.
        var game = new FakeGame
        {
            PictureLag = 2,
            Noise = 1,
            MovementBytes = 600,
        };
        using var session = new HarvestSession(Live with { MaxFrames = 1 }, game.Ports, new MemorySink());

        game.Run(session);

        Assert.Equal(new PictureLag(2, 2), session.Lag);
    }

    [Fact]
    public void Step_that_misses_a_tick_discards_the_frame()
    {
        var game = new FakeGame { PictureLag = 2 };
        using var session = new HarvestSession(Live with { LiveLag = new PictureLag(2, 2) }, game.Ports, new MemorySink());
        session.Step();
        game.Tick();
        game.Tick();
        session.Step();

        Assert.Equal(1, session.Counters.Discards["tickMissed"]);
    }

    [Fact]
    public void Step_with_a_spent_budget_keeps_boxes_without_occlusion()
    {
        var game = new FakeGame { MillisecondsPerRay = 3, Rays = static (_, _, _) => new RayHit(1, 101) };
        game.Entities = entities => [.. entities, entities[0] with { Handle = 102 }];
        var sink = new MemorySink();
        using var session = new HarvestSession(Live with { LiveLag = new PictureLag(0, 0), MaxFrames = 1 }, game.Ports, sink);

        game.Run(session);

        // Four rays of 3 ms for the first object spend the 4 ms.
        Assert.Equal([OcclusionMethod.Rays, OcclusionMethod.None], sink.Frames[0].Label.Objects.Select(label => label.OcclusionMethod));
        Assert.Equal([0, null], sink.Frames[0].Label.Objects.Select(label => label.OccludedFraction));
    }

    [Fact]
    public void Long_reading_of_the_scene_leaves_time_for_rays()
    {
        var game = new FakeGame { MillisecondsPerRay = 0.02, Rays = static (_, _, _) => new RayHit(1, 101) };
        game.OnCall = call => game.Work(call == nameof(FakeGame.ReadEntities) ? 2.5 : 0);
        var sink = new MemorySink();
        using var session = new HarvestSession(Live with { LiveLag = new PictureLag(0, 0), MaxFrames = 1 }, game.Ports, sink);

        game.Run(session);

        Assert.Equal(OcclusionMethod.Rays, Assert.Single(sink.Frames[0].Label.Objects).OcclusionMethod);
    }

    [Fact]
    public void Constructor_with_masks_is_refused() =>
        Assert.Throws<ArgumentException>(() => new HarvestSession(Live with { Masks = true }, new FakeGame().Ports, new MemorySink()));
}
