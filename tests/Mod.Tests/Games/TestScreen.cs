using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Play.Screen;
using Harvester.Sessions.Imaging;

namespace Harvester.Mod.Tests.Games;

/// <summary>A screen that shows the number of the frame, and records what else was visible when it was grabbed.</summary>
internal sealed class TestScreen(TestGame game) : IScreen, IGameWindow
{
    /// <summary>The picture differs by this many levels while an entity is hidden.</summary>
    private const int HiddenLevels = 100;

    /// <summary>Whether the picture changes with the entities that are hidden.</summary>
    public bool ShowsHiding { get; set; } = true;

    /// <summary>Whether the picture shows weather and time of day instead of the number of the frame.</summary>
    public bool ShowsSky { get; set; }

    /// <summary>Whether the picture shows the radar, as far as the game does.</summary>
    public bool ShowsRadar { get; set; }

    /// <summary>Factor on the colours of what the mod draws, up to white; null if the picture does not show it.</summary>
    public double? Gain { get; set; }

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
        int hidden = ShowsHiding && game.Entities.Values.Any(entity => entity.IsHidden) ? HiddenLevels : 0;
        long shown = ShowsSky ? (game.Environment.Weather.Length * 10) + game.Environment.TimeOfDay.Hours : game.Frame % 255;
        Array.Fill(target.Bytes, (byte)((1 + shown + hidden) % 256));
        if (ShowsRadar && game.ShowedRadar)
        {
            DrawRadar(target);
        }

        foreach (DrawnRectangle drawn in Gain is null ? [] : game.ShownRectangles)
        {
            Fill(target, drawn);
        }

        return Refusal is null ? GrabResult.Good : GrabResult.Refused(Refusal);
    }

    /// <summary>A green rectangle at the lower left.</summary>
    private static void DrawRadar(PixelBuffer target) => Fill(target, new Box2D(0, 0.75, 0.25, 1), 0, 200, 0);

    private void Fill(PixelBuffer target, DrawnRectangle drawn) =>
        Fill(target, drawn.Place, Bright(drawn.Colour.Red), Bright(drawn.Colour.Green), Bright(drawn.Colour.Blue));

    private byte Bright(int level) => (byte)Math.Min(byte.MaxValue, Gain!.Value * level);

    private static void Fill(PixelBuffer target, Box2D place, byte red, byte green, byte blue)
    {
        ImageSize size = target.Size;
        for (int row = (int)(place.YMin * size.Height); row < (int)(place.YMax * size.Height); row++)
        {
            for (int column = (int)(place.XMin * size.Width); column < (int)(place.XMax * size.Width); column++)
            {
                int pixel = PixelBuffer.BytesPerPixel * ((row * size.Width) + column);
                (target.Bytes[pixel], target.Bytes[pixel + 1], target.Bytes[pixel + 2]) = (red, green, blue);
            }
        }
    }
}
