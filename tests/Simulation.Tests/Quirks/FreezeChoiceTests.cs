using Harvester.Capture.Faults;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>Harvests that find out at their start in which of two ways the game is better frozen.</summary>
public sealed class FreezeChoiceTests
{
    private static readonly FreezeQuirks Restless = new() { NeverStands = true };
    private static readonly FreezeQuirks HeldCamera = new() { HoldsCamera = true };
    private static readonly FreezeQuirks Weather = new() { LetsWeatherGoOn = true };
    private static readonly FreezeQuirks Visibility = new() { ChangesVisibility = true };
    private static readonly FreezeQuirks None = new();

    public static TheoryData<FreezeQuirks, FreezeQuirks, FreezeMethod> Cases =>
        new()
        {
            { None, None, FreezeMethod.Paused },
            { None, Restless, FreezeMethod.Paused },
            { Restless, None, FreezeMethod.TimeScale },
            { Visibility, None, FreezeMethod.TimeScale },
            { HeldCamera, None, FreezeMethod.TimeScale },
            { Weather, None, FreezeMethod.TimeScale },
            { HeldCamera, Restless, FreezeMethod.Paused },
            { HeldCamera, Weather, FreezeMethod.TimeScale },
            {
                new FreezeQuirks { CreepTicks = 30 },
                None,
                FreezeMethod.TimeScale
            },
        };

    [Theory]
    [MemberData(nameof(Cases))]
    public void Harvest_uses_the_better_freeze_method_and_records_it(FreezeQuirks paused, FreezeQuirks timeScale, FreezeMethod expected)
    {
        SimulatedGame game = Game(paused, timeScale);
        using var session = new HarvestSession(Options, game.Ports, new MemorySink());
        Run(game, session);

        Assert.Null(session.Fault);
        Assert.Equal(expected, session.Freezing!.Method);
        Assert.Equal(expected, game.Ports.Pause.Method);
        Assert.Equal(3, session.Counters.Captured);
        Assert.Equal(2, session.Freezing.Findings.Count);
        Assert.All(session.Freezing.Findings, finding => Assert.True(finding.SawMovement));
        Assert.All(session.Freezing.Findings.Zip([paused, timeScale]), pair => Compare(pair.Second, pair.First));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Picture_lag_does_not_change_the_findings(int lag)
    {
        SimulatedGame game = Game(HeldCamera, None, new GameQuirks { PictureLagTicks = lag, IsCameraReportedLate = true });
        using var session = new HarvestSession(Options, game.Ports, new MemorySink());
        Run(game, session);

        Assert.Equal([false, true], session.Freezing!.Findings.Select(finding => finding.MovesCamera!.Value));
        Assert.Equal([0d, 0d], session.Freezing.Findings.Select(finding => finding.PictureChange!.Value));
    }

    [Fact]
    public void World_that_neither_method_freezes_causes_a_warning()
    {
        SimulatedGame game = Game(Restless, Restless);
        using var session = new HarvestSession(Options, game.Ports, new MemorySink());
        for (int tick = 0; tick < 2000 && session.Counters.Discarded < 2; tick++)
        {
            session.Step();
            game.Tick(1 / 60.0);
        }

        Assert.Contains(session.Warnings, warning => warning.Code == FaultCode.NeverStill);
        Assert.Equal(["neverStill"], session.Counters.Discards.Keys);
        session.Stop();
        game.Tick(1 / 60.0);
        Assert.False(game.IsFrozen);
    }

    [Fact]
    public void Given_freeze_method_is_used_without_a_trial()
    {
        SimulatedGame game = Game(None, None);
        using var session = new HarvestSession(Options with { FreezeBy = FreezeMethod.TimeScale }, game.Ports, new MemorySink());
        IReadOnlyList<HarvestPhase> phases = Run(game, session);

        Assert.Null(session.Freezing);
        Assert.Equal(FreezeMethod.TimeScale, game.Ports.Pause.Method);
        Assert.DoesNotContain(HarvestPhase.MeasuringFreeze, phases);
    }

    [Fact]
    public void Known_finding_is_used_without_a_trial()
    {
        SimulatedGame game = Game(None, None);
        FreezeReport known = FreezeReport.Of([
            new FreezeFinding(FreezeMethod.Paused, true, null),
            new FreezeFinding(FreezeMethod.TimeScale, true, 0),
        ]);
        using var session = new HarvestSession(Options with { KnownFreezing = known }, game.Ports, new MemorySink());
        IReadOnlyList<HarvestPhase> phases = Run(game, session);

        Assert.Same(known, session.Freezing);
        Assert.Equal(FreezeMethod.TimeScale, game.Ports.Pause.Method);
        Assert.DoesNotContain(HarvestPhase.MeasuringFreeze, phases);
    }

    [Fact]
    public void Stop_during_a_trial_restores_camera_and_world()
    {
        SimulatedGame game = Game(None, None);
        using var session = new HarvestSession(Options, game.Ports, new MemorySink());
        game.Tick(1 / 60.0);
        while (game.CameraMount.Position.X == 0)
        {
            session.Step();
            game.Tick(1 / 60.0);
        }

        Assert.True(game.IsFrozen);
        session.Stop();
        game.Tick(1 / 60.0);
        Assert.False(game.IsFrozen);
        Assert.Equal(0, game.CameraMount.Position.X);
    }

    private static HarvestOptions Options =>
        new()
        {
            Image = new ImageSize(80, 60),
            FreezeBy = null,
            MaxFrames = 3,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
        };

    private static void Compare(FreezeQuirks quirks, FreezeFinding found)
    {
        bool stands = !quirks.NeverStands && !quirks.ChangesVisibility;
        Assert.Equal(stands, found.HoldsWorld);
        Assert.Equal(stands ? !quirks.HoldsCamera : null, found.MovesCamera);
        Assert.Equal(stands ? !quirks.LetsWeatherGoOn : null, found.HoldsEnvironment);
        Assert.Equal(stands, found.PictureChange is not null);
        Assert.InRange(found.SettleTicks ?? 0, 0, quirks.CreepTicks + 1);
    }

    private static SimulatedGame Game(FreezeQuirks paused, FreezeQuirks timeScale, GameQuirks? others = null) =>
        new(
            new SimulationOptions
            {
                Seed = 3,
                RadiusMetres = 150,
                TrafficDensity = 0.3,
                PedestrianDensity = 0.3,
                Quirks = (others ?? new GameQuirks()) with { Paused = paused, TimeScale = timeScale },
            }
        );

    private static List<HarvestPhase> Run(SimulatedGame game, HarvestSession session)
    {
        List<HarvestPhase> phases = [];
        while (!session.Status.IsOver)
        {
            Assert.True(phases.Count < 5000, "The harvest does not come to its end.");
            game.Tick(1 / 60.0);
            phases.Add(session.Step().Phase);
        }

        return phases;
    }
}
