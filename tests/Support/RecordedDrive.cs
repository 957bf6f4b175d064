using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Capture.Storage;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Reading;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;

namespace Harvester.TestSupport;

/// <summary>
/// One short drive of the simulated game, to be harvested with whatever options; a session of it with the usual ones is made once.
/// </summary>
public sealed class RecordedDrive : IDisposable
{
    public const int Frames = 5;

    private readonly string _folder = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public RecordedDrive()
    {
        Session = Harvest("recorded", Options);
        FullSession = Harvest("full", Options with { MaxOccludedFraction = 1 });
        MaskedSession = Harvest("masked", Options with { Masks = true });
    }

    /// <summary>The simulated game's faces as they are read when they have been written: a session keeps them to the millimetre.</summary>
    public static FaceTable Table { get; } = FaceTableReader.Read(new StringReader(FaceTableWriter.Text(ModelFaces.Table))).Table;

    public static HarvestOptions Options { get; } =
        new()
        {
            Image = new ImageSize(320, 240),
            MaxFrames = Frames,
            RateHz = 1,
            Faces = Table,
        };

    /// <summary>The drive without masks.</summary>
    public SessionReader Session { get; }

    /// <summary>The same with what is hidden altogether.</summary>
    public SessionReader FullSession { get; }

    /// <summary>The drive with masks.</summary>
    public SessionReader MaskedSession { get; }

    /// <summary>The roads that the drive is on.</summary>
    public RoadNetwork Roads { get; private set; } = null!;

    public SessionReader Harvest(
        string name,
        HarvestOptions options,
        LookAhead? lookAhead = null,
        double laneWidth = RoadGeometry.LaneWidth
    )
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 3, WindowAspect = 4.0 / 3 });
        Roads = game.Roads;
        using var writer = new SessionWriter(
            PathOf(name),
            new SessionOrigin
            {
                Game = "simulation",
                Tool = "test",
                Seed = 3,
            }
        );
        using var session = new HarvestSession(
            options with
            {
                ProbeLag = false,
                MaxCalibrationErrorPixels = null,
            },
            game.Ports with
            {
                Roads = new FixedRoads(game.Roads, "roadFile", lookAhead, laneWidth),
            },
            writer
        );
        do
        {
            writer.WaitForRoom();
            game.Tick(1.0 / 60);
            session.Step();
        } while (!session.Status.IsOver);
        session.Stop();
        writer.Dispose();
        Assert.Null(session.Fault ?? writer.Fault);
        return new SessionReader(PathOf(name));
    }

    public string PathOf(string name) => Path.Combine(_folder, name);

    public void Dispose() => Directory.Delete(_folder, recursive: true);
}
