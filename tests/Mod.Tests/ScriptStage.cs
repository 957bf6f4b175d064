using GTA.Hosting;
using Harvester.Capture.Ports;
using Harvester.Play.Features;

namespace Harvester.Mod.Tests;

/// <summary>The stage of a script, used on the script's thread, as the script itself uses it in a tick.</summary>
internal sealed class ScriptStage(ScriptDriver driver) : IStage
{
    private StagedActors Stage => driver.Script.Actors;

    public StageSpawn Spawn(StageActor actor) => ScriptThread.Run(() => Stage.Spawn(actor));

    public void Follow(int handle, StageOrder order) => Do(() => Stage.Follow(handle, order));

    public void SetSpeed(int handle, double speed, double acceleration) => Do(() => Stage.SetSpeed(handle, speed, acceleration));

    public void SetDoor(int handle, int side, bool isOpen) => Do(() => Stage.SetDoor(handle, side, isOpen));

    public void SetIndicators(int handle, StageIndicators indicators) => Do(() => Stage.SetIndicators(handle, indicators));

    public void Remove(int handle) => Do(() => Stage.Remove(handle));

    public StageState? StateOf(int handle) => ScriptThread.Run(() => Stage.StateOf(handle));

    public void DriveEgo(StageOrder order) => Do(() => Stage.DriveEgo(order));

    /// <summary>Ends the stage, as the script does.</summary>
    public void Stop() => Do(driver.Script.Actors.Stop);

    private static void Do(Action part) =>
        ScriptThread.Run(() =>
        {
            part();
            return true;
        });
}
