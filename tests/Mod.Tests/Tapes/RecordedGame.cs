extern alias tapes;

using System.Windows.Forms;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Faces;
using Harvester.Simulation.Settings;
using tapes::Harvester.Tapes;

namespace Harvester.Mod.Tests.Tapes;

/// <summary>Tapes of the simulated game.</summary>
internal static class RecordedGame
{
    public const string Ini = "[Tape]\nRecord = Natives\n";
    public const int Ticks = 24;

    /// <summary>Settings with which a harvest uses most of what the game offers.</summary>
    public const string Busy = "[Harvest]\nWidth = 64\nHeight = 48\nRate = 5\nMasks = On\nOcclusionRays = 16\n";

    /// <summary>The tape of a harvest with these settings in a game without quirks.</summary>
    public static byte[] Plain => Recorded.Value;

    /// <summary>A town in which the mod finds some 200 people, about as many as the game ever has.</summary>
    public static SimulationOptions Options { get; } =
        new()
        {
            Seed = 14,
            TrafficDensity = 2,
            PedestrianDensity = 1.5,
        };

    private static readonly Lazy<byte[]> Recorded = new(() => Harvest(Options));

    /// <summary>A harvest in a simulated town; returns the tape.</summary>
    public static byte[] Harvest(SimulationOptions options, string ini = Busy, string recording = Ini, int ticks = Ticks)
    {
        string faces = File.ReadAllText(Path.Combine(BuiltMod.RepositoryRoot, "data", "spaces_of_interest.csv"));
        using var reader = new StringReader(faces);
        var scene = new SimulatedScene(options, FaceTableReader.Read(reader).Table);
        using var driver = new ScriptDriver(recording + ini, scene.PlayIn, scene.Ports.Screen, scene.Ports.Clock, faces);
        driver.Tick();
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();
        driver.Tick(ticks);
        driver.Script.RaiseKeyUp(Keys.J);
        driver.WaitForDisk();
        driver.Tick();
        Assert.DoesNotContain(driver.Game.Notifications, message => message.Contains("failed", StringComparison.Ordinal));
        return TapeOf(driver);
    }

    /// <summary>Ends the script and returns its tape.</summary>
    public static byte[] TapeOf(ScriptDriver driver)
    {
        driver.Script.RaiseAborted();
        driver.WaitForDisk();
        return File.ReadAllBytes(Assert.Single(Directory.GetFiles(driver.Output, "*.tape")));
    }

    /// <summary>Plays a tape.</summary>
    public static TapeResult Play(byte[] tape)
    {
        using var folder = new TemporaryFolder();
        return TapePlayer.Play(new MemoryStream(tape), folder.Path, CancellationToken.None);
    }
}
