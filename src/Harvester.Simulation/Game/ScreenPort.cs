using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Simulation.Game;

/// <summary>The picture of the simulated game, rendered at the requested size.</summary>
internal sealed class ScreenPort(SimulatedGame game) : IScreen
{
    public GrabResult Grab(PixelBuffer target)
    {
        game.Show(target);
        return GrabResult.Good;
    }
}
