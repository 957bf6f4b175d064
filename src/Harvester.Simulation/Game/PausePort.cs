using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>Freezes and resumes the simulated world.</summary>
internal sealed class PausePort(SimulatedGame game) : IPause
{
    public FreezeMethod Method
    {
        get => game.Freezing.Method;
        set => game.Freezing.Method = value;
    }

    public void Freeze() => game.Freezing.Freeze();

    public void Unfreeze() => game.Freezing.Unfreeze();
}
