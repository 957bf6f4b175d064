using System.Windows.Forms;
using GTA.Hosting;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Simulation.Tests.Faces.Survey;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests.Soak;

/// <summary>One game of a soak, made by its seed.</summary>
internal sealed class SoakPlay
{
    /// <summary>Small pictures and few rays, so that a tick costs little; all features are on their keys.</summary>
    private const string Ini =
        "[Bridge]\nKind = Folder\nFolder = out/bridge\nWidth = 40\nHeight = 30\nRecord = On\n"
        + "[Harvest]\nWidth = 160\nHeight = 120\nRate = 2\nOcclusionRays = 4\nRays = 200\nDriveLights = On\nFreeze = Auto\n"
        + "ImageFormat = Bmp\nMasks = ";

    private static readonly string[] Masks = ["Off", "Coded"];
    private const double MillisecondsOfATick = 16;

    /// <summary>Longer than any time that the mod waits for something.</summary>
    private const double LongWaitMilliseconds = 20_000;
    private const int TicksOfMemory = 1000;

    /// <summary>
    /// A tick of the game takes longer than most writes; the play's takes microseconds, in which a disk would never have room.
    /// </summary>
    private const int TicksOfDisk = 25;
    private const string Prop = "prop_sign_road_03g";

    /// <summary>Every key, one of the player's own, and those that need another to be of use after that one.</summary>
    private static readonly Keys[][] Presses =
    [
        .. ShippedKeys.All.Select(key => new[] { key }),
        [Keys.J],
        [Keys.W],
        [Keys.O, Keys.J],
        [Keys.O, Keys.N],
        [Keys.O, Keys.I, Keys.NumPad1],
        [Keys.O, Keys.Multiply],
        [Keys.NumPad2, Keys.NumPad2, Keys.Y],
        [Keys.O, Keys.Decimal],
    ];

    private readonly ScriptDriver _driver;
    private readonly TestGame _game;
    private readonly Random _random;
    private readonly FaultTally _tally;
    private readonly SoakFaults _faults;
    private int _grabs;

    public SoakPlay(ScriptDriver driver, int seed, FaultTally tally)
    {
        _driver = driver;
        _game = driver.Game;
        _random = new Random(seed);
        _tally = tally;
        _faults = new SoakFaults(driver, _random, tally);
        _game.Props[Prop] = KnownProps.All["octagon"];
        _game.Roads = new FakeRoadSource(RoadTests.Road());
        MakeWorld();
        File.WriteAllText(Path.Combine(driver.Folder, "plan.json"), PlanTests.Text);
    }

    /// <summary>The settings of a soak: every second one hides objects for its masks.</summary>
    public static string IniOf(int seed) => $"{Ini}{Masks[seed % Masks.Length]}\n{PlanTests.Ini}";

    public void Tick()
    {
        _driver.Clock.Milliseconds += Happens(2000) ? LongWaitMilliseconds : MillisecondsOfATick;
        _faults.Tick();
        ChangeWorld();
        try
        {
            if (Happens(60))
            {
                Press(Presses[_random.Next(Presses.Length)]);
            }

            _driver.Tick();
        }
        catch (ThreadAbortException) when (_faults.HasAbortedTheTick)
        {
            // The loader's own: it has stopped the script's thread in the middle of the tick.
        }

        // In the game that exception comes again out of every handler that takes it; here one that takes any exception ends it.
        bool isAborted = _faults.HasAbortedTheTick;
        Count();
        if (Happens(TicksOfDisk))
        {
            _driver.WaitForDisk();
        }

        if (isAborted || Happens(3000))
        {
            _tally.Add(isAborted ? "aborted within a tick" : "aborted between ticks");
            AssertNothingIsLeft();
            _faults.ResetTick();
            _driver.Reload();
        }

        if (_game.Frame % TicksOfMemory == 0)
        {
            _driver.WaitForDisk();
            _game.Calls.Clear();
            CountIf(
                _game.Notifications.Exists(message => message.Contains("The drive was recorded: ", StringComparison.Ordinal)),
                "drive was recorded"
            );
            _game.Notifications.Clear();
        }
    }

    /// <summary>Ends the script for good and checks what it has left.</summary>
    public void End() => AssertNothingIsLeft();

    private void AssertNothingIsLeft()
    {
        // Whoever cannot be given anything gets nothing back: a game that refuses everything is another test's.
        _faults.Stop();
        OtherThread.Do(_driver.Script.RaiseAborted);
        _driver.Script.RaiseAborted();
        Assert.True(
            !_game.LeftBehind.Any(),
            $"Left behind: {string.Join(", ", _game.LeftBehind)}\n{string.Join('\n', _game.Notifications.TakeLast(20))}"
        );
        _driver.Tick();
        Assert.Empty(_game.Balls);
        Assert.Empty(_game.Rectangles);
        Assert.Empty(_game.Texts);
        Assert.Empty(_game.Misuses);
    }

    private void Press(Keys[] keys)
    {
        foreach (Keys key in keys)
        {
            _driver.Script.RaiseKeyDown(key);
            _driver.Script.RaiseKeyUp(key);
        }
    }

    private void ChangeWorld()
    {
        if (Happens(2000))
        {
            _tally.Add("world was swept");
            _game.Entities.Clear();
            _game.LightOverrides.Clear();
            MakeWorld();
        }

        string bridge = Path.Combine(_driver.Output, "bridge");
        if (Happens(400) && Directory.Exists(bridge))
        {
            _tally.Add("client drove");
            ServedGame.Drop(bridge, "controls.txt", FormattableString.Invariant($"0.25 0.5 0 {_game.Frame}\n"));
        }

        if (Happens(800))
        {
            _tally.Add("car was left");
            _game.PlayersVehicle = 0;
        }
        else if (_game.PlayersVehicle == 0 && Happens(20))
        {
            _game.PlayersVehicle = _game.Vehicles.Any() ? _game.HandleOf(_game.Vehicles.First()) : 0;
        }
    }

    private void MakeWorld()
    {
        _game.Entities[TestGame.Player] = new GameEntity
        {
            Pool = PoolKind.Peds,
            Name = "player_zero",
            Pose = new Pose(new Vector3D(100, 200, 1), Axes.Identity),
        };
        HarvestTests.Street(_game);
        _game.Add(LightTests.LightAt(new Vector3D(104, 230, 0), Axes.Identity));
    }

    private void Count()
    {
        CountIf(_game.Balls.Count > 0, "ball was drawn");
        CountIf(_game.IsFrozen, "game stood still");
        CountIf(_game.Objects.Any(prop => prop.Name == Prop), "model was put up");
        CountIf(!_game.IsRadarOn && !_game.IsHudOn, "radar and HUD were off");
        CountIf(_game.Entities.Values.Any(entity => entity.IsHidden), "entity was hidden");
        CountIf(_driver.Screen.Grabs > _grabs, "frame was harvested");
        _grabs = _driver.Screen.Grabs;
    }

    private void CountIf(bool happens, string kind)
    {
        if (happens)
        {
            _tally.Add(kind);
        }
    }

    private bool Happens(int onceIn) => _random.Next(onceIn) == 0;
}
