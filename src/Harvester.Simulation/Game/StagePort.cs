using Harvester.Capture.Ports;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Game;

/// <summary>Actors in the simulated game, which are moved exactly as ordered until they meet a body.</summary>
internal sealed class StagePort(SimulatedGame game) : IStage
{
    private WorldStage Stage => game.World.Stage ?? throw new InvalidOperationException("The game has gone to a place that has no stage.");

    public StageSpawn Spawn(StageActor actor) => game.Changed(Stage.Spawn(actor));

    public void Follow(int handle, StageOrder order) => Stage.Follow(handle, order);

    public void SetSpeed(int handle, double speed, double acceleration) => Stage.SetSpeed(handle, speed, acceleration);

    public void SetDoor(int handle, int side, bool isOpen)
    {
        Stage.SetDoor(handle, side, isOpen);
        game.Changed(0);
    }

    public void SetIndicators(int handle, StageIndicators indicators)
    {
        Stage.SetIndicators(handle, indicators);
        game.Changed(0);
    }

    public void Remove(int handle)
    {
        Stage.Remove(handle);
        game.Changed(0);
    }

    public StageState? StateOf(int handle) => Stage.StateOf(handle);

    public void DriveEgo(StageOrder order) => Stage.DriveEgo(order);
}
