using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Ports;

/// <summary>Takes the picture that the game shows.</summary>
public interface IScreen
{
    /// <summary>
    /// Grabs the picture shown now, scaled to the size of the buffer. A picture that cannot be trusted (no window, minimised,
    /// covered, black) is refused with a reason, not thrown; the buffer's content is then undefined.
    /// </summary>
    /// <param name="target">Where the pixels go.</param>
    GrabResult Grab(PixelBuffer target);
}
