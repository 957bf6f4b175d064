using Harvester.Sessions.Imaging;

namespace Harvester.Capture.Ports;

/// <summary>
/// A screen whose pictures another thread draws while the game goes on. The harvest waits for them, so that only a game that can stand
/// still, such as a simulated one, should have such a screen.
/// </summary>
public interface IDeferringScreen : IScreen
{
    /// <summary>
    /// Grabs the current picture like <see cref="IScreen.Grab"/>, but returns before its pixels are known. What the game does afterwards
    /// does not change them. Pictures are drawn in the order in which they were grabbed, and the picture can always be used.
    /// </summary>
    /// <param name="target">Receives the pixels; must not be used until the task has ended.</param>
    /// <returns>Ends when the pixels are drawn, or with the failure of drawing them.</returns>
    Task GrabLater(PixelBuffer target);
}
