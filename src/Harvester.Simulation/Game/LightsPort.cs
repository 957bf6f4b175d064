using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Game;

/// <summary>What the traffic lights of the simulated world show. Unlike the real one it tells.</summary>
internal sealed class LightsPort(SimulatedGame game) : ILights
{
    /// <summary>No scene is labelled later than this after it was read, seconds.</summary>
    private const double MaxDelay = PictureLag.MaxTicks / 60.0;

    public LightState? SetStateOf(int entity, long gameFrame)
    {
        SimulatedWorld world = game.World;
        LightState? now = world.LightAt(entity, world.TimeSeconds);

        // A world that stands still shows what it showed when it was read. In one that goes on a light may have changed since.
        bool isOfNow = game.IsFrozen || gameFrame == game.GameFrame;
        return isOfNow || now == world.LightAt(entity, world.TimeSeconds - MaxDelay) ? now : null;
    }
}
