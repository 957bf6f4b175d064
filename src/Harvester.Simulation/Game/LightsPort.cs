using Harvester.Capture.Ports;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Game;

/// <summary>The states of the simulated traffic lights, which the simulation knows, unlike the real game.</summary>
internal sealed class LightsPort(SimulatedGame game) : ILights
{
    /// <summary>Maximum time between reading a scene and labelling it, seconds.</summary>
    private const double MaxDelay = PictureLag.MaxTicks / 60.0;

    public LightState? SetStateOf(int entity, long gameFrame)
    {
        SimulatedWorld world = game.World;
        LightState? now = world.LightAt(entity, world.TimeSeconds);

        // A frozen world shows the state that was read. In a running one a light may have changed since.
        bool isOfNow = game.IsFrozen || gameFrame == game.GameFrame;
        return isOfNow || now == world.LightAt(entity, world.TimeSeconds - MaxDelay) ? now : null;
    }
}
