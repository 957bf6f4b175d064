using Harvester.Capture.Ports;

namespace Harvester.Simulation.Game;

/// <summary>Draws colours over the picture of the simulated game.</summary>
internal sealed class CardPort(SimulatedGame game) : IColourCard
{
    public void Show(IReadOnlyList<ColourPatch> patches) => game.Layers.Card = patches;

    public void Clear() => game.Layers.Card = [];
}
