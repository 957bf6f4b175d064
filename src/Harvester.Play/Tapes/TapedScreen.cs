using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;

namespace Harvester.Play.Tapes;

/// <summary>A screen whose pictures are recorded.</summary>
/// <param name="screen">The screen.</param>
/// <param name="tape">The recording.</param>
public sealed class TapedScreen(IScreen screen, TapeRecorder tape) : IScreen
{
    /// <inheritdoc/>
    public GrabResult Grab(PixelBuffer target)
    {
        GrabResult result = screen.Grab(target);
        tape.Grab(target, result);
        return result;
    }
}
