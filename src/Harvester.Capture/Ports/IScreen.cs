using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Ports;

/// <summary>Grabs the picture that the game shows.</summary>
public interface IScreen
{
    /// <summary>
    /// Grabs the current picture, scaled to the size of the buffer. If the picture is not usable (no window, minimised, covered, black),
    /// the result has a reason and nothing is thrown; the buffer's content is then undefined.
    /// </summary>
    /// <param name="target">Receives the pixels.</param>
    GrabResult Grab(PixelBuffer target);
}
