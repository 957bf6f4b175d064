using Harvester.Capture.Imaging;
using Harvester.Capture.Ports;
using Harvester.Capture.Scenes;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>The game's screen, with note taken of what the last picture that was grabbed truly shows.</summary>
internal sealed class WatchedScreen(SimulatedGame game) : IScreen
{
    public SceneSnapshot Truth { get; private set; } = game.Shown;

    /// <summary>The handles that have a pixel in the picture.</summary>
    public HashSet<int> Seen { get; private set; } = [];

    public GrabResult Grab(PixelBuffer target)
    {
        GrabResult result = game.Ports.Screen.Grab(target);
        Truth = game.Shown;
        Seen = [.. game.Render(target.Size).Handles];
        return result;
    }
}
