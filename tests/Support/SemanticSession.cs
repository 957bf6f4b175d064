using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.TestSupport;

/// <summary>A small harvest with class maps.</summary>
internal sealed class SemanticSession : IDisposable
{
    public const int Frames = 2;

    public SemanticSession(SemanticsMethod method, Shard? shard = null)
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 8, WindowAspect = 4.0 / 3 });
        using var writer = new SessionWriter(
            Folder,
            new SessionOrigin
            {
                Game = "simulation",
                Tool = "test",
                Seed = 8,
                Settings = shard is { } part ? [new("shard", part.ToString())] : [],
            }
        );
        var options = new HarvestOptions
        {
            Image = new ImageSize(200, 150),
            MaxFrames = Frames,
            RateHz = 1,
            RangeMetres = 80,
            Masks = true,
            Semantics = method,
            Shard = shard ?? Shard.Whole,
        };
        using var session = new HarvestSession(options, game.Ports with { Roads = new FixedRoads(game.Roads, "simulation") }, writer);
        do
        {
            writer.WaitForRoom();
            game.Tick(1.0 / 60);
            session.Step();
        } while (!session.Status.IsOver);
        session.Stop();
        writer.Dispose();
        Assert.Null(session.Fault ?? writer.Fault);
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public SessionReader Open() => new(Folder);

    public string PathOf(string name) => Path.Combine(Folder, name);

    public void Dispose() => Directory.Delete(Folder, recursive: true);
}
