using System.Windows.Forms;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Simulation.Tests.Faces.Survey;
using Harvester.TestSupport;

namespace Harvester.Mod.Tests;

/// <summary>A play in which every native of the mod is called.</summary>
internal static class Playthrough
{
    /// <summary>The settings that it needs.</summary>
    public const string Ini =
        "[Bridge]\nKind = Folder\nFolder = out/bridge\nRecord = On\n[Harvest]\nDriveLights = On\nFreeze = Auto\n" + PlanTests.Ini;

    /// <summary>More than a calibration takes that looks for markers in vain.</summary>
    private const int TicksOfCalibration = 400;

    /// <summary>More than both trials take in a world that freezes at once and whose camera moves at once: 34 ticks each.</summary>
    private const int TicksOfFreezeTrials = 80;
    private const string Failed = " failed: ";
    private const string Stopped = " stopped: ";

    /// <summary>Everything that a player can do, once.</summary>
    public static void Of(ScriptDriver driver)
    {
        driver.Press(Keys.NumPad0);
        driver.Tick(8);
        driver.Press(Keys.NumPad0);
        driver.Tick(8);
        HarvestTests.Street(driver.Game);
        HarvestTests.SunkenCar(driver.Game);
        driver.Game.Add(LightTests.LightAt(new Vector3D(104, 230, 0), Axes.Identity));
        driver.Game.Roads = new FakeRoadSource(RoadTests.Road());
        driver.Press(Keys.U);
        driver.WaitForDisk();
        driver.Tick(5);
        driver.Press(Keys.U);
        driver.WaitForDisk();
        SurveySigns(driver);
        driver.Game.Entities[TestGame.Player].Pose = new Pose(new Vector3D(104, 220, 1), Axes.Identity);
        driver.Press(Keys.NumPad2);
        driver.Press(Keys.Divide);
        driver.WaitForDisk();
        driver.Press(Keys.L);
        driver.Press(Keys.I);
        driver.Press(Keys.NumPad1);
        driver.Tick(TicksOfCalibration);
        driver.Press(Keys.J);
        driver.Tick(TicksOfFreezeTrials + 25);
        driver.Press(Keys.J);
        driver.WaitForDisk();
        PlayDrive(driver);
        driver.Game.BrokenList = _ => [];
        driver.Press(Keys.K);
        driver.Tick(25);
        driver.WaitForDisk();
        driver.Game.BrokenList = null;
        driver.Press(Keys.O);
        (driver.Game.PlayersVehicle, driver.Game.IsInCutScene, driver.Game.WantedLevel) = (0, true, 1);
        PlanTests.Run(driver);
    }

    private static void SurveySigns(ScriptDriver driver)
    {
        driver.Game.Props["prop_sign_road_03g"] = KnownProps.All["prop_traffic_03a"];
        int before = driver.Game.Notifications.Count;
        driver.Press(Keys.Multiply);
        driver.Until(() => HasMessageSince(driver, before, "models are surveyed", Failed, Stopped));
        driver.WaitForDisk();
    }

    /// <summary>A drive over the shared folder, with each command that calls a native; a fault ends it.</summary>
    private static void PlayDrive(ScriptDriver driver)
    {
        string folder = Path.Combine(driver.Output, "bridge");
        int before = driver.Game.Notifications.Count;
        driver.Press(Keys.N);
        Until(Hash.SET_CONTROL_VALUE_NEXT_FRAME);
        Directory.CreateDirectory(folder);
        ServedGame.Drop(folder, "command.json", """{"type":"reset","position":[1,2,3],"headingDegrees":0}""");
        Until(Hash.SET_ENTITY_VELOCITY);
        ServedGame.Drop(folder, "command.json", """{"type":"environment","weather":"rain","timeOfDay":"08:15"}""");
        Until(Hash.SET_CLOCK_TIME);
        Until(Hash.GET_CONTROL_NORMAL);

        void Until(Hash native) =>
            driver.Until(
                () => driver.Game.Calls.Contains(native) || HasMessageSince(driver, before, Failed, Stopped),
                ServedGame.ClientsPauseMilliseconds
            );
    }

    private static bool HasMessageSince(ScriptDriver driver, int before, params string[] words) =>
        driver.Game.Notifications.Skip(before).Any(message => words.Any(word => message.Contains(word, StringComparison.Ordinal)));
}
