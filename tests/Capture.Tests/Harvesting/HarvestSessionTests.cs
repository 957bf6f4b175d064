using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Harvesting;

/// <summary>The session's way from phase to phase, and its end by faults, the sink and the caller.</summary>
public sealed class HarvestSessionTests
{
    private static readonly HarvestOptions Small = new()
    {
        Image = new ImageSize(64, 48),
        OcclusionSamples = 4,
        ProbeLag = false,
        MaxPictureLagTicks = 2,
    };

    public static TheoryData<string, int> Calls
    {
        get
        {
            var data = new TheoryData<string, int>();
            foreach (
                string call in new[] { "ReadCamera", "ReadEgo", "ReadEntities", "ReadEnvironment", "Cast", "Grab", "Freeze", "Unfreeze" }
            )
            {
                data.Add(call, 1);
                data.Add(call, 5);
            }

            return data;
        }
    }

    [Fact]
    public void Step_runs_through_the_phases_of_a_frame()
    {
        var game = new FakeGame();
        using var session = new HarvestSession(Small with { MaxFrames = 2 }, game.Ports, new MemorySink());

        // Frame 0 is due at once: read at ticks 0, 1 and 2, grabbed at the third. 10 a second of 60 ticks: the next is due 6 states later.
        Assert.Equal(
            [
                HarvestPhase.Settling,
                HarvestPhase.Settling,
                HarvestPhase.Waiting,
                HarvestPhase.Waiting,
                HarvestPhase.Waiting,
                HarvestPhase.Waiting,
                HarvestPhase.Waiting,
                HarvestPhase.Waiting,
                HarvestPhase.Settling,
                HarvestPhase.Settling,
                HarvestPhase.Stopped,
            ],
            game.Run(session)
        );
    }

    [Theory]
    [InlineData(10)]
    [InlineData(7)]
    [InlineData(60)]
    [InlineData(200)]
    public void Step_takes_frames_at_the_rate_of_the_games_time(double rateHz)
    {
        var game = new FakeGame();
        var sink = new MemorySink();
        using var session = new HarvestSession(Small with { RateHz = rateHz, MaxFrames = 100 }, game.Ports, sink);

        game.Run(session);

        // Never more than one tick late, and delays do not add up; a game of 60 ticks gives no more than 60 frames.
        double period = 1 / Math.Min(rateHz, FakeGame.TicksPerSecond);
        Assert.All(
            sink.Frames.Select((frame, index) => frame.Label.TimeSeconds - (index * period)),
            late => Assert.InRange(late, -1e-9, (1 / FakeGame.TicksPerSecond) - 1e-9)
        );
    }

    [Theory]
    [MemberData(nameof(Calls))]
    public void Step_with_a_failing_port_ends_the_harvest_with_its_message(string port, int failingCall)
    {
        int calls = 0;
        var game = new FakeGame();
        game.OnCall = call =>
        {
            if (call == port && ++calls == failingCall)
            {
                throw new InvalidOperationException($"{port} broke\nin two lines.");
            }
        };
        var sink = new MemorySink();
        var session = new HarvestSession(Small, game.Ports, sink);

        game.Run(session, 2_000);

        Assert.Equal(HarvestPhase.Faulted, session.Status.Phase);
        Assert.Equal($"The harvest stopped: {port} broke in two lines.", session.Fault);
        Assert.False(game.WantsFrozen);
        if (sink.Start is not null)
        {
            Assert.Equal(session.Fault, sink.End!.Fault);
            Assert.Equal(sink.Frames.Count, sink.End.Captured);
        }

        HarvestStatus after = session.Status;
        session.Stop();
        Assert.Equal(after, session.Step());
    }

    [Fact]
    public void Step_reports_a_game_that_cannot_be_unfrozen()
    {
        var game = new FakeGame
        {
            OnCall = call => _ = call is "Grab" or "Unfreeze" ? throw new InvalidOperationException($"{call} broke.") : 0,
        };
        var sink = new MemorySink();
        var session = new HarvestSession(Small, game.Ports, sink);

        game.Run(session, 100);

        Assert.Equal("The harvest stopped: Unfreeze broke. Ending it failed too: Unfreeze broke.", session.Fault);
        Assert.NotNull(sink.End);
    }

    [Fact]
    public void Step_with_a_full_sink_lets_the_game_run_and_keeps_the_frame()
    {
        var game = new FakeGame();
        var sink = new MemorySink { HasRoom = false };
        using var session = new HarvestSession(Small with { MaxFrames = 2 }, game.Ports, sink);
        IReadOnlyList<HarvestPhase> phases = game.Run(session, 100);

        Assert.Equal(98, phases.Count(phase => phase == HarvestPhase.WaitingForSink));
        Assert.Equal(98, session.Counters.TicksWaitedForSink);
        Assert.False(game.WantsFrozen);
        Assert.Equal(0, session.Counters.Captured);

        sink.HasRoom = true;
        game.Run(session);
        Assert.Equal([0, 1], sink.Frames.Select(frame => frame.Label.Frame));
        Assert.Equal(0, sink.Frames[0].Label.TimeSeconds);
        Assert.Equal(0, FakeGame.StateOf(sink.Frames[0].Picture));
    }

    [Fact]
    public void Step_with_a_sink_that_failed_ends_with_the_sinks_message()
    {
        var game = new FakeGame();
        var sink = new MemorySink();
        using var session = new HarvestSession(Small, game.Ports, sink);
        game.Run(session, 20);
        sink.Fault = "The disk is full.";

        Assert.Equal(HarvestPhase.Faulted, session.Step().Phase);
        Assert.Equal("The disk is full.", session.Fault);
        Assert.Equal("The disk is full.", sink.End!.Fault);
        Assert.False(game.WantsFrozen);
    }

    [Fact]
    public void Stop_in_a_frozen_game_unfreezes_it_and_closes_the_sink()
    {
        var game = new FakeGame();
        var sink = new MemorySink();
        var session = new HarvestSession(Small, game.Ports, sink);
        session.Step();
        Assert.True(game.WantsFrozen);

        session.Stop();
        session.Stop();

        Assert.False(game.WantsFrozen);
        Assert.Equal(HarvestPhase.Stopped, session.Status.Phase);
        Assert.Null(sink.End!.Fault);
        Assert.Empty(sink.Frames);
    }

    [Fact]
    public void Stop_before_the_first_step_opens_nothing()
    {
        var sink = new MemorySink();
        var session = new HarvestSession(Small, new FakeGame().Ports, sink);

        session.Stop();

        Assert.True(session.Step().IsOver);
        Assert.Null(sink.Start);
        Assert.Null(sink.End);
    }

    [Fact]
    public void Step_with_too_many_objects_to_number_ends_with_a_message()
    {
        // Each state has a different car.
        var game = new FakeGame();
        game.Entities = entities => [.. entities.Select(entity => entity with { Handle = 1_000 + (int)game.State })];
        var sink = new MemorySink { FirstObjectId = 65_534 };
        using var session = new HarvestSession(Small with { RateHz = 60 }, game.Ports, sink);

        game.Run(session);

        Assert.Equal([65_534, 65_535], sink.Frames.Select(frame => Assert.Single(frame.Label.Objects).Id));
        Assert.Equal("This session has used all 65,535 object numbers. Start a new session.", session.Fault);
    }

    [Fact]
    public void Same_harvest_twice_gives_the_same_labels()
    {
        string[][] runs =
        [
            .. Enumerable
                .Range(0, 2)
                .Select(_ =>
                {
                    var game = new FakeGame { PictureLag = 1, FreezeDelay = 2 };
                    game.Entities = entities => [.. entities, entities[0] with { Handle = 5, Class = ObjectClass.Bus }];
                    var sink = new MemorySink();
                    using var session = new HarvestSession(Small with { MaxFrames = 20, ProbeLag = true }, game.Ports, sink);
                    game.Run(session);
                    return sink.Frames.Select(frame => JsonLabelWriter.Line(frame.Label)).ToArray();
                }),
        ];

        Assert.Equal(20, runs[0].Length);
        Assert.Equal(runs[0], runs[1]);
    }

    [Fact]
    public void Step_reads_entities_up_to_the_ignore_region_range()
    {
        var asked = new List<(Vector3D Centre, double Range)>();
        var game = new FakeGame();
        var world = new RecordingWorld(game, asked);
        using var session = new HarvestSession(
            Small with
            {
                RangeMetres = 80,
                IgnoreRangeMetres = 90,
                MaxFrames = 1,
            },
            game.Ports with
            {
                World = world,
            },
            new MemorySink()
        );

        game.Run(session);

        Assert.NotEmpty(asked);
        Assert.All(asked, query => Assert.Equal((new Vector3D(0, 0, 1.5), 90), query));
    }

    [Fact]
    public void Frame_labels_objects_in_range_and_ignores_those_beyond()
    {
        // The car's origin is 12 m ahead and 2 m to the right of the camera; the bus is 40 m ahead.
        var game = new FakeGame
        {
            Entities = cars =>
                [.. cars, cars[0] with { Handle = 5, Class = ObjectClass.Bus, Pose = new Pose(new Vector3D(-2, 40, 0.6), Axes.Identity) }],
            Rays = (ray, _, _) => new RayHit(ray.Direction.X > 0 ? 10 : 38, ray.Direction.X > 0 ? 101 : 5),
        };
        var sink = new MemorySink();
        using var session = new HarvestSession(
            Small with
            {
                RangeMetres = 30,
                MinBoxAreaPixels = 0,
                MinBoxSidePixels = 0,
                MaxFrames = 1,
            },
            game.Ports,
            sink
        );

        game.Run(session);

        CapturedFrame frame = Assert.Single(sink.Frames);
        Assert.Equal([ObjectClass.Car], frame.Label.Objects.Select(item => item.Class));
        Assert.Equal(
            [(IgnoreReason.BeyondRange, ObjectClass.Bus)],
            frame.Label.IgnoreRegions.Select(region => (region.Reason, region.Class))
        );
        Assert.Equal([101], frame.Scene!.Snapshot.Entities.Select(entity => entity.Handle));
        Assert.Equal([(5, Sight.Seen)], frame.Scene.Distant.Select(distant => (distant.Entity.Handle, distant.Sight)));
    }
}
