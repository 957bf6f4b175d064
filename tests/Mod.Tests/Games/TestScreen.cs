using Harvester.Capture.Ports;
using Harvester.Play.Screen;
using Harvester.Sessions.Imaging;

namespace Harvester.Mod.Tests.Games;

/// <summary>A screen that shows the number of the frame, and records what else was visible when it was grabbed.</summary>
internal sealed class TestScreen(TestGame game) : IScreen, IGameWindow
{
    public string? Refusal { get; set; }

    /// <summary>Grabs with anything of the game's display or the mod's in the picture.</summary>
    public int SpoiltPictures { get; private set; }

    public int Grabs { get; private set; }

    public string Describe() => "1920 x 1080, borderless, 96 dpi";

    public GrabResult Grab(PixelBuffer target)
    {
        Grabs++;

        // The picture grabbed in a tick is the one that the frame before drew.
        SpoiltPictures += game.ShowedDisplay ? 1 : 0;
        Array.Fill(target.Bytes, (byte)(1 + (game.Frame % 255)));
        return Refusal is null ? GrabResult.Good : GrabResult.Refused(Refusal);
    }
}
