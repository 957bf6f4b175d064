using Harvester.Capture.Ports;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Imaging;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>A screen that shows the picture of a number of ticks ago; before as many ticks, its first picture.</summary>
internal sealed class LateScreen(IScreen screen, ImageSize image, int ticks) : IScreen
{
    private readonly Queue<byte[]> _pictures = [];

    /// <summary>Takes the picture of a tick; to be called in each.</summary>
    public void Tick()
    {
        var picture = new PixelBuffer(image);
        screen.Grab(picture);
        _pictures.Enqueue(picture.Bytes);
        if (_pictures.Count > ticks + 1)
        {
            _pictures.Dequeue();
        }
    }

    public GrabResult Grab(PixelBuffer target)
    {
        _pictures.Peek().CopyTo(target.Bytes, 0);
        return GrabResult.Good;
    }
}
