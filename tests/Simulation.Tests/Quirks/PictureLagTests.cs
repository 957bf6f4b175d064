using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>The lag of the picture, measured in towns where the world creeps on when it is frozen.</summary>
public sealed class PictureLagTests(ITestOutputHelper output)
{
    private const double TickSeconds = 1 / 60.0;
    private const int MaxTicks = 6_000;

    // As after a check of the camera, which has shown already that the picture lag is within the limit.
    private static readonly HarvestOptions Options = new()
    {
        Image = new ImageSize(80, 60),
        MaxCalibrationErrorPixels = null,
        KnownCalibrationErrorPixels = 0.1,
        MaxFrames = 1,
    };

    [Theory]
    [InlineData(4)]
    [InlineData(7)]
    [InlineData(10)]
    [InlineData(21)]
    [Trait("Category", "Heavy")]
    public void Creep_is_not_mistaken_for_lag(int seed)
    {
        var quirks = new GameQuirks
        {
            PictureLagTicks = 2,
            Paused = new FreezeQuirks { CreepTicks = 3 },
        };

        Assert.Equal(new PictureLag(2, 2), Measure(seed, quirks, Options with { Freeze = false }).Lag);
        Assert.Null(Measure(seed, quirks, Options).Fault);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [Trait("Category", "Heavy")]
    public void Long_lag_is_measured_in_full(int seed)
    {
        var quirks = new GameQuirks
        {
            PictureLagTicks = 10,
            Paused = new FreezeQuirks { CreepTicks = 3 },
        };

        Assert.Equal(new PictureLag(10, 10), Measure(seed, quirks, Options with { Freeze = false, MaxPictureLagTicks = 12 }).Lag);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [Trait("Category", "Heavy")]
    public void Lag_is_exact_over_seeds_lags_and_creeps(int creep)
    {
        var wrong = new List<string>();
        int runs = 0;
        foreach (int seed in ProofSize.Of([4, 8], [1, 2, 3, 4, 5, 6, 7, 8]))
        {
            string weather = seed % 4 == 0 ? "rain" : "clear";
            bool isCameraLate = seed % 2 == 1;
            var quirks = new GameQuirks
            {
                IsCameraReportedLate = isCameraLate,
                Paused = new FreezeQuirks { CreepTicks = creep, LetsWeatherGoOn = seed % 8 == 0 },
            };
            SimulatedGame game = Game(seed, quirks, weather);
            for (int lag = 0; lag <= 3; lag++)
            {
                PictureLag? measured = Measure(
                    game,
                    Options with
                    {
                        Freeze = false,
                    },
                    new LateScreen(game.Ports.Screen, Options.Image, lag)
                ).Lag;
                runs++;
                if (measured != new PictureLag(isCameraLate ? lag - 1 : lag, lag))
                {
                    wrong.Add($"seed {seed}, {weather}, lag {lag}, late camera {isCameraLate}: {measured?.ToString() ?? "unknown"}");
                }
            }
        }

        output.WriteLine($"{wrong.Count} of {runs} wrong");
        Assert.True(wrong.Count == 0, string.Join("\n", wrong));
    }

    private static (PictureLag? Lag, string? Fault) Measure(int seed, GameQuirks quirks, HarvestOptions options) =>
        Measure(Game(seed, quirks, "clear"), options, null);

    /// <summary>Starts a harvest and follows it until it has measured the lag, or ended.</summary>
    private static (PictureLag? Lag, string? Fault) Measure(SimulatedGame game, HarvestOptions options, LateScreen? screen)
    {
        GamePorts ports = screen is null ? game.Ports : game.Ports with { Screen = screen };
        using var session = new HarvestSession(options, ports, new MemorySink());
        for (int tick = 0; tick < MaxTicks && session.Lag is null && !session.Status.IsOver; tick++)
        {
            game.Tick(TickSeconds);
            screen?.Tick();
            session.Step();
        }

        return (session.Lag, session.Fault);
    }

    private static SimulatedGame Game(int seed, GameQuirks quirks, string weather) =>
        new(
            new SimulationOptions
            {
                Seed = seed,
                Quirks = quirks,
                Weather = weather,
                RadiusMetres = 100,
                TrafficDensity = 0.7,
                PedestrianDensity = 0.3,
            }
        );
}
