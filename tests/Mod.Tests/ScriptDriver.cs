using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>
/// Loads the script into a test game and raises its events as the loader does. An exception that leaves a handler fails the test:
/// the loader would abort the script for one out of a tick.
/// </summary>
internal sealed class ScriptDriver : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public ScriptDriver(string ini = "", Action<TestGame>? prepare = null)
    {
        File.WriteAllText(Path.Combine(_folder.Path, "GtaDataHarvester.ini"), ini);
        Game = new TestGame(_folder.Path);
        prepare?.Invoke(Game);
        GameHost.Current = Game;
        Script = new HarvesterScript();
    }

    public TestGame Game { get; }

    public HarvesterScript Script { get; private set; }

    public string Log => File.ReadAllText(Path.Combine(_folder.Path, "GtaDataHarvester.log"));

    public void Tick(int count = 1)
    {
        for (int i = 0; i < count; i++)
        {
            Game.NextFrame();
            Script.RaiseTick();
        }
    }

    /// <summary>Presses and releases a key, and lets a frame go by.</summary>
    public void Press(Keys key)
    {
        Script.RaiseKeyDown(key);
        Script.RaiseKeyUp(key);
        Tick();
    }

    /// <summary>What loading a saved game does to scripts: the old one is ended and a new one made.</summary>
    public void Reload()
    {
        Script.RaiseAborted();
        Script = new HarvesterScript();
    }

    public void Dispose() => _folder.Dispose();
}
