using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Datasets.Sessions;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Datasets.Tests.Exports;

/// <summary>A small harvest of the simulated game with masks and lanes, made once for all tests of exports.</summary>
public sealed class SimulatedSession : IDisposable
{
    public const string Collection = "Simulated session";
    public const int Frames = 7;

    public SimulatedSession()
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 8, WindowAspect = 4.0 / 3 });
        using var writer = new SessionWriter(Folder, new SessionOrigin { Game = "simulation", Tool = "test", Seed = 8 });
        using var session = new HarvestSession(
            new HarvestOptions { Image = new ImageSize(200, 150), MaxFrames = Frames, RateHz = 2, RangeMetres = 80, Masks = true },
            game.Ports with { Roads = new FixedRoads(game.Roads, "simulation") },
            writer);
        do
        {
            writer.WaitForRoom();
            game.Tick(1.0 / 60);
            session.Step();
        }
        while (!session.Status.IsOver);
        session.Stop();
        writer.Dispose();
        Assert.Null(session.Fault ?? writer.Fault);
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public SessionReader Open() => new(Folder);

    public void Dispose() => Directory.Delete(Folder, recursive: true);
}
