using System.Globalization;
using Harvester.Capture.Harvesting;
using Harvester.Capture.Storage;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Roads;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Repair;

/// <summary>A small session with every kind of file, for tests to damage; it can be made whole again.</summary>
public sealed class DamagedSession : IDisposable
{
    public const int Frames = 3;

    private readonly string _parent = Directory.CreateTempSubdirectory("harvester-test-").FullName;
    private readonly Dictionary<string, byte[]> _files;

    public DamagedSession()
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 3, WindowAspect = 4.0 / 3 });
        using (
            var writer = new SessionWriter(
                Folder,
                new SessionOrigin
                {
                    Game = "simulation",
                    Tool = "test",
                    Seed = 3,
                }
            )
        )
        {
            using var text = new StringWriter(CultureInfo.InvariantCulture);
            RoadCsvWriter.Write(game.Roads, text);
            writer.Keep(FramePaths.Roads, text.ToString());
            using var session = new HarvestSession(
                new HarvestOptions
                {
                    Image = new ImageSize(80, 60),
                    MaxFrames = Frames,
                    RateHz = 1,
                    Faces = RecordedDrive.Table,
                    Masks = true,
                },
                game.Ports,
                writer
            );
            while (!session.Step().IsOver)
            {
                writer.WaitForRoom();
                game.Tick(1.0 / 60);
            }
        }

        _files = Directory.EnumerateFiles(Folder, "*", SearchOption.AllDirectories).ToDictionary(file => file, File.ReadAllBytes);
    }

    public string Folder => Path.Combine(_parent, "session");

    public string Repaired => Path.Combine(_parent, "repaired");

    public SessionReader Open() => new(Folder);

    public string PathOf(string name) => Path.Combine(Folder, name);

    /// <summary>Makes the session whole again, and deletes what was repaired.</summary>
    public void Restore()
    {
        foreach ((string file, byte[] bytes) in _files)
        {
            // A link in its place would be followed.
            File.Delete(file);
            File.WriteAllBytes(file, bytes);
        }

        if (Directory.Exists(Repaired))
        {
            Directory.Delete(Repaired, recursive: true);
        }
    }

    /// <summary>Makes it one of an earlier version, which has no manifest and does not say that it has.</summary>
    public void MakeOlder()
    {
        File.Delete(PathOf("manifest.jsonl"));
        string header = File.ReadAllText(PathOf("session.json"));
        string older = header.Replace("\n  \"manifest\": true,", "", StringComparison.Ordinal);
        Assert.NotEqual(header, older);
        File.WriteAllText(PathOf("session.json"), older);
    }

    /// <summary>Flips one bit of a file.</summary>
    public void Flip(string name, int bit)
    {
        byte[] bytes = File.ReadAllBytes(PathOf(name));
        bytes[bit / 8] ^= (byte)(1 << (bit % 8));
        File.WriteAllBytes(PathOf(name), bytes);
    }

    /// <summary>Number of bits of a file.</summary>
    public int Bits(string name) => checked((int)new FileInfo(PathOf(name)).Length * 8);

    public void Dispose() => Directory.Delete(_parent, recursive: true);
}
