using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>The frozen harvest against a game whose pictures show the number of their state.</summary>
public sealed class FrozenHarvestTests
{
    private static readonly HarvestOptions Small = new()
    {
        Image = new ImageSize(64, 48),
        MaxFrames = 25,
        OcclusionSamples = 4,
    };

    public static TheoryData<int, int, bool> Quirks
    {
        get
        {
            var data = new TheoryData<int, int, bool>();
            for (int lag = 0; lag <= 3; lag++)
            {
                for (int delay = 0; delay <= 3; delay++)
                {
                    data.Add(lag, delay, false);
                    data.Add(lag, delay, true);
                }
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Quirks))]
    public void Step_with_picture_lag_keeps_only_frames_that_match_labels(int lag, int delay, bool cameraLate)
    {
        var game = new FakeGame
        {
            PictureLag = lag,
            FreezeDelay = delay,
            CameraReportedLate = cameraLate,
        };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small, game.Ports, sink);

        game.Run(session);

        Assert.Null(session.Fault);
        Assert.Equal(25, sink.Frames.Count);
        Assert.Equal(0, Mismatches(sink));
        Assert.False(game.WantsFrozen);

        // The camera is still on its way for a tick when it is reported late; otherwise the world stands after the delay.
        int settle = delay + (cameraLate ? 1 : 0);
        Assert.Equal([KeyValuePair.Create(settle, 25)], sink.End!.SettleTicks);
        Assert.Equal(new PictureLag(cameraLate ? lag - 1 : lag, lag), sink.End.Lag);
    }

    [Theory]
    [MemberData(nameof(Quirks))]
    public void Readings_over_several_ticks_keep_matching_frames_only(int lag, int delay, bool cameraLate)
    {
        const int ticksOfAReading = 3;
        var game = new FakeGame
        {
            PictureLag = lag,
            FreezeDelay = delay,
            CameraReportedLate = cameraLate,
        };
        GamePorts ports = game.Ports with { World = new SlowWorld(game, ticksOfAReading) };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { ProbeLag = false }, ports, sink);

        game.RunAlone(10);
        game.Run(session);

        Assert.Equal(25, sink.Frames.Count);
        Assert.Equal(0, session.Counters.Discarded);
        Assert.Equal(0, Mismatches(sink));
    }

    [Fact]
    public void Movement_after_the_grab_discards_the_frame()
    {
        var game = new FakeGame();
        bool grabbed = false;
        game.OnCall = call => grabbed |= call == "Grab";
        game.Entities = entities =>
            grabbed
                ? [entities[0] with { Pose = entities[0].Pose with { Position = entities[0].Pose.Position + new Vector3D(0, 0.01, 0) } }]
                : entities;
        using var session = new HarvestSession(Small with { ProbeLag = false }, game.Ports, new MemorySink());

        game.Run(session, 10);

        Assert.Equal(0, session.Counters.Captured);
        Assert.Equal(["objectMoved"], session.Counters.Discards.Keys);
    }

    [Fact]
    public void Judge_detects_frames_with_a_lag_above_the_limit()
    {
        // The control for the test above: with room for 2 ticks and a lag of 3, pictures and labels must be found to disagree.
        var game = new FakeGame { PictureLag = 3 };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { MaxPictureLagTicks = 2, ProbeLag = false }, game.Ports, sink);

        game.RunAlone(10);
        game.Run(session);

        Assert.Equal(25, Mismatches(sink));
    }

    [Fact]
    public void Step_detects_a_lag_above_the_limit_by_probing()
    {
        var game = new FakeGame { PictureLag = 3 };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { MaxPictureLagTicks = 2 }, game.Ports, sink);

        game.Run(session);

        Assert.Equal(0, session.Counters.Captured);
        Assert.Equal("The image is 3 ticks or more behind the game; the harvest allows 2.", session.Fault);
    }

    [Theory]
    [InlineData(7)]
    [InlineData(40)]
    [InlineData(60)]
    public void Step_detects_a_lag_far_above_the_limit_by_probing(int lag)
    {
        var game = new FakeGame { PictureLag = lag };
        game.RunAlone(lag);
        var sink = new MemorySink();
        using var session = new HarvestSession(Small, game.Ports, sink);
        game.Run(session);

        Assert.StartsWith(
            $"The image is {lag} ticks or more behind the game; the harvest allows 4.",
            session.Fault,
            StringComparison.Ordinal
        );
        Assert.Empty(sink.Frames);
        Assert.False(game.WantsFrozen);
    }

    [Fact]
    public void Step_in_a_standing_world_harvests_without_a_measured_lag()
    {
        var game = new FakeGame { MetresPerTick = 0, PictureLag = 2 };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small, game.Ports, sink);

        game.Run(session);

        Assert.Equal(25, sink.Frames.Count);
        Assert.Null(session.Lag);
        Assert.Equal([FaultCode.LagUnchecked], session.Warnings.Select(warning => warning.Code));
    }

    [Fact]
    public void Step_in_a_world_that_creeps_while_frozen_discards_all_frames()
    {
        // 0.3 mm a tick: no tick differs by the millimetre that counts, but four of them do.
        var game = new FakeGame();
        game.Entities = entities =>
            [
                .. entities.Select(entity =>
                    entity with
                    {
                        Pose = entity.Pose with { Position = entity.Pose.Position + new Vector3D(game.GameFrame * 0.0003, 0, 0) },
                    }
                ),
            ];
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { ProbeLag = false, MaxSettleTicks = 10 }, game.Ports, sink);

        game.Run(session, 500);

        Assert.Equal(0, session.Counters.Captured);
        Assert.True(session.Counters.Discarded > 10);
        Assert.Equal([KeyValuePair.Create("neverStill", session.Counters.Discarded)], session.Counters.Discards);
    }

    [Fact]
    public void Step_with_refused_pictures_counts_them_by_their_reason()
    {
        var game = new FakeGame();
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { ProbeLag = false }, game.Ports, sink);
        game.GrabAnswer = Ports.GrabResult.Refused("minimised");
        game.Run(session, 200);
        game.GrabAnswer = Ports.GrabResult.Good;
        int discarded = session.Counters.Discarded;
        game.Run(session);

        Assert.True(discarded > 5);
        Assert.Equal(discarded, session.Counters.Discards["minimised"]);
        Assert.Equal(discarded, session.Counters.Discarded);
        Assert.Equal(25, sink.Frames.Count);
        Assert.Equal(Enumerable.Range(0, 25), sink.Frames.Select(frame => frame.Label.Frame));
        Assert.Equal(0, Mismatches(sink));
    }

    [Theory]
    [InlineData("vanish", "objectsChanged")]
    [InlineData("model", "objectsChanged")]
    [InlineData("move", "objectMoved")]
    public void Step_discards_the_frame_when_the_world_changes_during_a_grab(string change, string reason)
    {
        var game = new FakeGame();
        bool grabbed = false;
        game.OnCall = call =>
            grabbed = call switch
            {
                "Grab" => true,
                "Unfreeze" => false,
                _ => grabbed,
            };
        game.Entities = entities =>
            !grabbed
                ? entities
                : change switch
                {
                    "vanish" => [],
                    "model" => [.. entities.Select(entity => entity with { Model = "other" })],
                    _ =>
                    [
                        .. entities.Select(entity =>
                            entity with
                            {
                                Pose = entity.Pose with { Position = entity.Pose.Position + new Vector3D(0, 0, 0.002) },
                            }
                        ),
                    ],
                };
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { ProbeLag = false }, game.Ports, sink);

        game.Run(session, 100);

        Assert.Equal(0, session.Counters.Captured);
        Assert.True(session.Counters.Discards[reason] > 2);
        Assert.Single(session.Counters.Discards);
    }

    [Fact]
    public void Step_discards_the_frame_when_the_world_moves_while_labelling()
    {
        // Each ray takes 3 ms of the 4 of a tick's budget, so labelling goes over ticks; then the pause is lost.
        var game = new FakeGame { MillisecondsPerRay = 3 };
        game.Entities = entities => [.. entities, entities[0] with { Handle = 102 }, entities[0] with { Handle = 103 }];
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { ProbeLag = false }, game.Ports, sink);
        for (int tick = 0; tick < 100; tick++)
        {
            if (session.Step().Phase == HarvestPhase.Labelling)
            {
                game.Unfreeze();
            }

            game.Tick();
        }

        Assert.Equal(0, session.Counters.Captured);
        Assert.True(session.Counters.Discards["timeMoved"] > 2);
    }

    [Fact]
    public void Step_labels_the_same_over_several_ticks_as_in_one()
    {
        var sinks = new List<MemorySink>();
        foreach (double millisecondsPerRay in new[] { 0.0, 3.0 })
        {
            var game = new FakeGame { MillisecondsPerRay = millisecondsPerRay };
            game.Entities = entities => [.. entities, entities[0] with { Handle = 102 }, entities[0] with { Handle = 103 }];
            var sink = new MemorySink();
            using var session = new HarvestSession(Small with { ProbeLag = false }, game.Ports, sink);
            bool isSliced = game.Run(session).Contains(HarvestPhase.Labelling);
            Assert.Equal(millisecondsPerRay > 0, isSliced);
            sinks.Add(sink);
        }

        Assert.All(sinks[0].Frames.Zip(sinks[1].Frames), pair => Assert.Equal(pair.First.Label.Objects, pair.Second.Label.Objects));
    }

    private static int Mismatches(MemorySink sink) =>
        sink.Frames.Count(frame => FakeGame.StateOf(frame.Picture) != FakeGame.StateAt(frame.Label.TimeSeconds));
}
