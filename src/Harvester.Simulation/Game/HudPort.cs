using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>Hides the head-up display of the simulated game.</summary>
internal sealed class HudPort(SimulatedGame game) : IHud
{
    public bool? IsWanted => game.Layers.HasHud;

    public void Hide() => game.Layers.IsHudHidden = true;

    public void Show() => game.Layers.IsHudHidden = false;

    public void Restore() => game.Layers.IsHudHidden = false;
}
