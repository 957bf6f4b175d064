using System.Diagnostics;
using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Capture.Ports;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>
/// Loads the script into a test game and raises its events as the loader does. An exception that leaves a handler fails the test:
/// the loader would abort the script for one out of a tick.
/// </summary>
internal sealed class ScriptDriver : IDisposable
{
    private static readonly TimeSpan HangingAfter = TimeSpan.FromMinutes(1);
    private readonly TemporaryFolder _folder = new();
    private readonly IScreen _screen;
    private readonly IClock _clock;

    /// <summary>Scripts that were ended may still be writing: a script waits for a slow disk for a limited time only.</summary>
    private readonly List<HarvesterScript> _ended = [];

    public ScriptDriver(
        string ini = "",
        Action<TestGame>? prepare = null,
        IScreen? screen = null,
        IClock? clock = null,
        string? faces = "# none\n"
    )
    {
        // What a harvest does before its first frame, and how often it takes one, is left out where a test does not ask for it.
        string display = ini.Contains("CheckDisplay =", StringComparison.Ordinal) ? string.Empty : "CheckDisplay = Off\n";
        string rate = ini.Contains("Rate =", StringComparison.Ordinal) ? string.Empty : "Rate = 10\n";
        string freeze = ini.Contains("Freeze =", StringComparison.Ordinal) ? string.Empty : "Freeze = Paused\n";
        File.WriteAllText(
            Path.Combine(_folder.Path, "GtaDataHarvester.ini"),
            $"{ini}\n[Harvest]\nFolder = out\nProbeLag = Off\n{rate}{display}{freeze}[Lens]\nMaxError = 0\n"
        );
        if (faces is not null)
        {
            File.WriteAllText(Path.Combine(_folder.Path, "spaces_of_interest.csv"), faces);
        }

        Game = new TestGame(_folder.Path);
        prepare?.Invoke(Game);
        GameHost.Current = Game;
        Screen = new TestScreen(Game);
        _screen = screen ?? Screen;
        _clock = clock ?? Clock;
        Script = Load();
    }

    public TestGame Game { get; }

    public TestClock Clock { get; } = new();

    public TestScreen Screen { get; }

    /// <summary>The folder that the mod lies in.</summary>
    public string Folder => _folder.Path;

    /// <summary>The game's settings.xml, which is there only where a test writes it.</summary>
    public string GraphicsFile => Path.Combine(_folder.Path, "settings.xml");

    /// <summary>The folder that sessions go to.</summary>
    public string Output => Path.Combine(_folder.Path, "out");

    public HarvesterScript Script { get; private set; }

    /// <summary>What is in the log when all is written.</summary>
    public string Log()
    {
        WaitForDisk();
        return File.ReadAllText(Path.Combine(_folder.Path, "GtaDataHarvester.log"));
    }

    /// <summary>The label lines of the one session in the output.</summary>
    public string[] Labels() => File.ReadAllLines(Path.Combine(Assert.Single(Directory.GetDirectories(Output)), "labels.jsonl"));

    public void Tick(int count = 1)
    {
        for (int i = 0; i < count && Game.GivesTicks; i++)
        {
            Game.NextFrame();
            Script.RaiseTick();
        }
    }

    /// <summary>Presses and releases a key, waits until what it asks for is read, and lets a frame go by.</summary>
    public void Press(Keys key)
    {
        Script.RaiseKeyDown(key);
        Script.RaiseKeyUp(key);
        WaitForDisk();
        Tick();
    }

    /// <summary>What loading a saved game does to scripts: the old one is ended and a new one made.</summary>
    public void Reload()
    {
        Script.RaiseAborted();
        _ended.Add(Script);
        Script = Load();
    }

    /// <summary>
    /// Waits until the scripts' work on other threads is done: what they harvested is written, and what they requested is read.
    /// </summary>
    public void WaitForDisk()
    {
        while (Script.IsBusy || _ended.Exists(script => script.IsBusy))
        {
            Thread.Sleep(1);
        }
    }

    /// <summary>Lets ticks go by until something is so, however slow the machine is.</summary>
    /// <param name="isSo">Asked before each tick.</param>
    /// <param name="pauseMilliseconds">Time between ticks for processes outside the script: the clients of a drive.</param>
    public void Until(Func<bool> isSo, int pauseMilliseconds = 0)
    {
        var hanging = Stopwatch.StartNew();
        while (!isSo())
        {
            Assert.True(hanging.Elapsed < HangingAfter, "It never comes.\n" + string.Join('\n', Game.Notifications));
            WaitForDisk();
            Thread.Sleep(pauseMilliseconds);
            Tick();
        }
    }

    /// <summary>Runs ticks until the player gets a message.</summary>
    public void UntilMessage(string message) =>
        Until(() => Game.Notifications.Any(shown => shown.Contains(message, StringComparison.Ordinal)));

    /// <summary>
    /// Ends the script as an unloading domain does: on another thread, and once more. What the real API would not have borne fails the
    /// test.
    /// </summary>
    public void Dispose()
    {
        OtherThread.Do(Script.RaiseAborted);
        Script.RaiseAborted();
        WaitForDisk();
        _folder.Dispose();
        Assert.Empty(Game.Misuses);
    }

    private HarvesterScript Load() => ScriptThread.Run(() => new HarvesterScript(_screen, _clock, Game.Build, GraphicsFile));
}
