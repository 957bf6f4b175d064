using Harvester.Capture.Ports;
using Harvester.Sessions.Imaging;
using Harvester.Simulation.Game;
using Harvester.Simulation.Tests.Labelling;

namespace Harvester.Simulation.Tests.Quirks;

/// <summary>The game's screen, with note taken of what the last picture that was grabbed truly shows.</summary>
internal sealed class WatchedScreen(SimulatedGame game) : IScreen
{
    /// <summary>What the last picture that was grabbed truly shows; null before the first.</summary>
    public TruePicture? Truth { get; private set; }

    public GrabResult Grab(PixelBuffer target)
    {
        GrabResult result = game.Ports.Screen.Grab(target);
        Truth = new TruePicture(game.Shown, game.Render(target.Size));
        return result;
    }
}
