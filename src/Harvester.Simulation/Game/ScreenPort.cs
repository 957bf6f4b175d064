using System;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>The picture of the simulated game, rendered at the requested size.</summary>
internal sealed class ScreenPort(SimulatedGame game) : IScreen
{
    public GrabResult Grab(PixelBuffer target)
    {
        RenderTarget picture = game.Render(target.Size);
        Buffer.BlockCopy(picture.Colour, 0, target.Bytes, 0, target.Bytes.Length);
        return GrabResult.Good;
    }
}
