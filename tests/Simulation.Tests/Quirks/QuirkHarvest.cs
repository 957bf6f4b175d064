using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>A small harvest of a town at noon whose game has quirks.</summary>
internal sealed class QuirkHarvest : IDisposable
{
    private const double TicksPerSecond = 10;

    private readonly HarvestSession _session;

    /// <summary>Harvests to the end.</summary>
    /// <param name="quirks">The quirks.</param>
    /// <param name="options">What to harvest; size, lag and calibration are set here.</param>
    /// <param name="prepare">Called before the first tick.</param>
    public QuirkHarvest(GameQuirks quirks, HarvestOptions options, Action<SimulatedGame>? prepare = null)
    {
        Game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = 61,
                WindowAspect = 4.0 / 3,
                IsWarm = true,
                Detail = Detail.Plain,
                TimeOfDay = TimeSpan.FromHours(12),
                Quirks = quirks,
            }
        );
        _session = new HarvestSession(
            options with
            {
                Image = new ImageSize(320, 240),
                ProbeLag = false,
                MaxCalibrationErrorPixels = null,
            },
            Game.Ports,
            Sink
        );
        prepare?.Invoke(Game);
        while (!_session.Step().IsOver)
        {
            Game.Tick(1 / TicksPerSecond);
        }

        Assert.Null(_session.Fault);
    }

    public SimulatedGame Game { get; }

    public MemorySink Sink { get; } = new() { KeepsFrames = false };

    public HarvestSession Session => _session;

    public void Dispose() => _session.Dispose();
}
