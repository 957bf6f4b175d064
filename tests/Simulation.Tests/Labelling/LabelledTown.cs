using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Tests.Doubles;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Labelling;

/// <summary>Harvests of a simulated town, frame by frame with what each picture truly shows.</summary>
internal static class LabelledTown
{
    private const double TicksPerSecond = 60;

    /// <summary>Harvests a town with all its faces.</summary>
    /// <param name="simulation">The town.</param>
    /// <param name="options">What to harvest.</param>
    /// <param name="judge">Called with each frame.</param>
    public static void Harvest(SimulationOptions simulation, HarvestOptions options, Action<CapturedFrame, TruePicture> judge)
    {
        var game = new SimulatedGame(simulation);
        Harvest(game, game.Ports, options, judge);
    }

    /// <summary>Harvests a game through other ports than its own.</summary>
    public static void Harvest(SimulatedGame game, GamePorts ports, HarvestOptions options, Action<CapturedFrame, TruePicture> judge)
    {
        MemorySink sink = new();
        HarvestOptions asked = options with { ProbeLag = false, MaxCalibrationErrorPixels = null, Faces = ModelFaces.Table };
        using HarvestSession session = new(asked, ports, sink);
        bool isOver = false;
        while (!isOver)
        {
            isOver = session.Step().IsOver;
            foreach (CapturedFrame frame in sink.Frames)
            {
                judge(frame, new TruePicture(game.Shown, game.Render(options.Image)));
                frame.Dispose();
            }

            sink.Frames.Clear();
            game.Tick(1 / TicksPerSecond);
        }

        Assert.Null(session.Fault);
        Assert.Equal(options.MaxFrames, session.Counters.Captured);
    }
}
