using Harvester.Capture.Harvesting;
using Harvester.Capture.Tests.Doubles;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>A moment of a rig in the simulated game, which still stands at that moment.</summary>
internal sealed class RigHarvest
{
    private const double TicksPerSecond = 60;

    public RigHarvest(Rig rig, int seed, HarvestOptions? labelling = null)
    {
        Game = new SimulatedGame(new SimulationOptions { Seed = seed, IsWarm = true });
        var sink = new MemorySink();
        HarvestOptions options = (labelling ?? new HarvestOptions()) with
        {
            Rig = rig,
            Image = rig.Cameras[0].Image,
            Lens = rig.Cameras[0].Lens,
            MaxFrames = rig.Cameras.Count,
            RateHz = 2,
            ProbeLag = false,
            MaxCalibrationErrorPixels = null,
        };
        using var session = new HarvestSession(options, Game.Ports, sink);
        Game.Ports.RigCamera!.Show(rig.Cameras[0], rig.OnVehicle(rig.Cameras[0].Mount));
        do
        {
            Game.Tick(1 / TicksPerSecond);
        } while (!session.Step().IsOver);
        Assert.Null(session.Fault);
        Frames = [.. sink.Frames];
        Assert.Equal(rig.Cameras.Count, Frames.Count);
    }

    /// <summary>The game, whose world has moved on by no tick since.</summary>
    public SimulatedGame Game { get; }

    /// <summary>The views of the moment.</summary>
    public IReadOnlyList<CapturedFrame> Frames { get; }

    /// <summary>A camera of a test.</summary>
    public static RigCamera Camera(string name, Vector3D position, double yawDegrees, ImageSize image, double fovDegrees = 60) =>
        new(name, new Pose(position, Axes.FromEuler(new EulerAngles(0, 0, yawDegrees))), fovDegrees, image, Lens.Ideal);
}
