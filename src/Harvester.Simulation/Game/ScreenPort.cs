using System;
using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Game;

/// <summary>The picture that the simulated game shows; it is rendered at the size that is asked for.</summary>
internal sealed class ScreenPort(SimulatedGame game) : IScreen
{
    public GrabResult Grab(PixelBuffer target)
    {
        RenderTarget picture = game.Render(target.Size);
        Buffer.BlockCopy(picture.Colour, 0, target.Bytes, 0, target.Bytes.Length);
        return GrabResult.Good;
    }
}
