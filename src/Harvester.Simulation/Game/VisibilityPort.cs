using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>Hides entities from the pictures of the simulated game.</summary>
internal sealed class VisibilityPort(SimulatedGame game) : IVisibility
{
    public IReadOnlyCollection<int>? Announce(IReadOnlyCollection<int> entities) => entities;

    public void HideOnly(IReadOnlyCollection<int> entities) => game.Hidden.Ask(entities);

    public void ShowAll() => game.Hidden.Ask([]);
}
