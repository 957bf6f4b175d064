using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>Harvests a game with all quirks, and compares each kept frame with what its picture truly shows.</summary>
public sealed class HarvestWithQuirksTests
{
    private const double Range = 60;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Step_with_all_quirks_keeps_only_frames_that_match_labels() => Harvest(lag: 3, frames: 40);

    public static TheoryData<int> Lags => [.. ProofSize.Of([0, 3], [0, 1, 2, 3])];

    [Theory]
    [Trait("Category", "Heavy")]
    [MemberData(nameof(Lags))]
    public void Step_for_long_with_all_quirks_keeps_only_matching_frames(int lag) => Harvest(lag, frames: 400);

    [Fact]
    [Trait("Category", "Heavy")]
    public void Judge_detects_frames_of_a_harvest_that_ignores_picture_lag()
    {
        // With a lag of 3 ticks and no wait each picture is older than its label, which shows as long as something moves.
        // The check of the camera at the start, which would refuse such a harvest, is left out with its markers.
        SimulatedGame game = Game(lag: 3);
        (int wrong, _, _) = Judge(game, game.Ports with { Markers = null }, Options(frames: 10) with { MaxPictureLagTicks = 0 });

        Assert.True(wrong > 5, $"Only {wrong} of 10 frames are found wrong.");
    }

    private static void Harvest(int lag, int frames)
    {
        SimulatedGame game = Game(lag);
        (int wrong, int marked, HarvestCounters counters) = Judge(game, game.Ports, Options(frames));

        Assert.Equal(0, wrong);
        Assert.Equal(frames, counters.Captured);

        // The quirks did bite: worlds that crept on, and entities that were gone at the second reading, and vehicles that rays missed.
        Assert.True(counters.SettleTicks.Count > 2, "Nothing crept.");
        Assert.True(counters.Discards.GetValueOrDefault("objectsChanged") > 0, "Nothing vanished.");
        Assert.True(marked > 0, "Rays missed nothing.");
    }

    private static SimulatedGame Game(int lag) =>
        new(
            new SimulationOptions
            {
                Seed = 5,
                TrafficDensity = 0.5,
                PedestrianDensity = 0.3,
                Quirks = new GameQuirks
                {
                    PictureLagTicks = lag,
                    IsCameraReportedLate = true,
                    Paused = new FreezeQuirks { HoldsCamera = true, CreepTicks = 3 },
                    VanishingFraction = 0.05,
                    RaysMeetBoxes = true,
                    RayMissFraction = 0.3,
                },
                WindowAspect = 1.6,
                Lens = new RenderLens(1.008, 0, 0, -0.02, 0),
            }
        );

    private static HarvestOptions Options(int frames) =>
        new()
        {
            Image = new ImageSize(64, 48),
            RangeMetres = Range,
            IgnoreRangeMetres = Range,
            MaxFrames = frames,
            RateHz = 6,
            OcclusionSamples = 1,
            MaxOccludedFraction = 1,
            MinBoxAreaPixels = 0,
            MinBoxSidePixels = 0,
            ProbeLag = false,
            Lens = new Lens(1.008, 0, 0, -0.02, 0),
        };

    private static (int Wrong, int Marked, HarvestCounters Counters) Judge(SimulatedGame game, GamePorts ports, HarvestOptions options)
    {
        const double ticksPerSecond = 60;
        WatchedScreen screen = new(game);
        int wrong = 0;
        int marked = 0;
        MemorySink sink = new() { KeepsFrames = false };
        sink.OnFrame = frame =>
        {
            wrong += FrameJudge.Disagreements(frame.Label, screen.Truth!, Range).Any() ? 1 : 0;
            marked += frame.Label.IgnoreRegions.Count;
        };
        using HarvestSession session = new(options, ports with { Screen = screen }, sink);
        for (int tick = 0; !session.Step().IsOver; tick++)
        {
            Assert.True(tick < 100_000, "The harvest does not come to its end.");
            game.Tick(1 / ticksPerSecond);
        }

        Assert.Null(session.Fault);
        return (wrong, marked, session.Counters);
    }
}
