using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Simulation.Game;

/// <summary>The picture of the simulated game, rendered by another thread where the caller can wait for it.</summary>
internal sealed class DeferringScreenPort(SimulatedGame game) : IDeferringScreen
{
    private readonly ScreenPort _screen = new(game);

    public GrabResult Grab(PixelBuffer target) => _screen.Grab(target);

    public Task GrabLater(PixelBuffer target) => game.RenderLater(target);
}
