using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.TestSupport;

/// <summary>A small harvest of the simulated game with masks and lanes, made once for all tests of exports.</summary>
public sealed class SimulatedSession : IDisposable
{
    public const string Collection = "Simulated session";
    public const int Frames = 7;

    private readonly Lazy<string> _withClassMaps = new(() => Harvest(SemanticsMethod.Exact));
    private readonly Lazy<string> _withRoads = new(() => Harvest(null, keepsRoads: true));

    private readonly Lazy<string> _withFlow = new(() => Harvest(null, channels: [FrameChannels.Flow.Key, FrameChannels.Imu.Key]));

    private readonly Lazy<string> _withVoxels = new(() => Harvest(null, channels: [FrameChannels.Occupancy.Key]));

    public string Folder { get; } = Harvest(null);

    public SessionReader Open() => new(Folder);

    /// <summary>Opens the same session with class maps.</summary>
    public SessionReader OpenWithClassMaps() => new(_withClassMaps.Value);

    /// <summary>Opens the same session with the roads beside its scenes.</summary>
    public SessionReader OpenWithRoads() => new(_withRoads.Value);

    /// <summary>Opens the same session with flow and an inertial unit.</summary>
    public SessionReader OpenWithFlow() => new(_withFlow.Value);

    /// <summary>Opens the same session with voxels.</summary>
    public SessionReader OpenWithVoxels() => new(_withVoxels.Value);

    public void Dispose()
    {
        Directory.Delete(Folder, recursive: true);
        foreach (Lazy<string> made in (Lazy<string>[])[_withClassMaps, _withRoads, _withFlow, _withVoxels])
        {
            if (made.IsValueCreated)
            {
                Directory.Delete(made.Value, recursive: true);
            }
        }
    }

    private static string Harvest(SemanticsMethod? semantics, bool keepsRoads = false, params string[] channels)
    {
        string folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;
        var game = new SimulatedGame(new SimulationOptions { Seed = 8, WindowAspect = 4.0 / 3 });
        using var writer = new SessionWriter(
            folder,
            new SessionOrigin
            {
                Game = "simulation",
                Tool = "test",
                Seed = 8,
            }
        );
        var options = new HarvestOptions
        {
            Image = new ImageSize(200, 150),
            MaxFrames = Frames,
            RateHz = 2,
            RangeMetres = 80,
            Masks = true,
            Semantics = semantics,
            Channels = new ChannelKeys(channels),
        };
        RoadNetwork roads = game.Roads;
        if (keepsRoads)
        {
            using var text = new StringWriter();
            RoadCsvWriter.Write(roads, text);
            writer.Keep(FramePaths.Roads, text.ToString());
            roads = RoadCsvReader.Read(new StringReader(text.ToString()));
        }

        using var session = new HarvestSession(options, game.Ports with { Roads = new FixedRoads(roads, "simulation") }, writer);
        do
        {
            writer.WaitForRoom();
            game.Tick(1.0 / 60);
            session.Step();
        } while (!session.Status.IsOver);
        session.Stop();
        writer.Dispose();
        Assert.Null(session.Fault ?? writer.Fault);
        return folder;
    }
}
