using GTA.Native;
using Harvester.Geometry;
using Harvester.Play.Features;

namespace Harvester.Mod;

/// <summary>Draws by the game's natives.</summary>
internal sealed class GameDisplay : IDisplay
{
    private const int Opaque = 255;

    /// <summary>A label of the game that consists of ten texts in a row.</summary>
    private const string TenTexts = "CELL_EMAIL_BCON";
    private const int MaxPieces = 10;

    /// <inheritdoc/>
    public void Rectangle(Box2D place, Colour colour) =>
        Natives.Call(
            Hash.DRAW_RECT,
            (float)((place.XMin + place.XMax) / 2),
            (float)((place.YMin + place.YMax) / 2),
            (float)place.Width,
            (float)place.Height,
            colour.Red,
            colour.Green,
            colour.Blue,
            Opaque,
            false
        );

    /// <inheritdoc/>
    public void Text(string text, double left, double top)
    {
        const float scale = 0.35f;
        const int white = 255;
        Natives.Call(Hash.SET_TEXT_FONT, 0);
        Natives.Call(Hash.SET_TEXT_SCALE, scale, scale);
        Natives.Call(Hash.SET_TEXT_COLOUR, white, white, white, Opaque);
        Natives.Call(Hash.SET_TEXT_OUTLINE);
        Natives.Call(Hash.BEGIN_TEXT_COMMAND_DISPLAY_TEXT, TenTexts);
        foreach (string piece in TextPieces.Of(GameText.Plain(text)).Take(MaxPieces))
        {
            Natives.Call(Hash.ADD_TEXT_COMPONENT_SUBSTRING_PLAYER_NAME, piece);
        }

        Natives.Call(Hash.END_TEXT_COMMAND_DISPLAY_TEXT, (float)left, (float)top, 0);
    }

    /// <summary>Draws the game's sphere without a texture; its scale is its radius.</summary>
    public void Ball(Vector3D centre, double radiusMetres, Colour colour)
    {
        const int sphere = 28;
        const string? noTexture = null;
        float scale = (float)radiusMetres;
        Natives.Call(
            Hash.DRAW_MARKER,
            sphere,
            (float)centre.X,
            (float)centre.Y,
            (float)centre.Z,
            0f,
            0f,
            0f,
            0f,
            0f,
            0f,
            scale,
            scale,
            scale,
            colour.Red,
            colour.Green,
            colour.Blue,
            Opaque,
            false,
            false,
            Natives.RotationOrder,
            false,
            noTexture,
            noTexture,
            false
        );
    }

    /// <inheritdoc/>
    public void Triangle(Vector3D a, Vector3D b, Vector3D c, Colour colour) =>
        Natives.Call(
            Hash.DRAW_POLY,
            (float)a.X,
            (float)a.Y,
            (float)a.Z,
            (float)b.X,
            (float)b.Y,
            (float)b.Z,
            (float)c.X,
            (float)c.Y,
            (float)c.Z,
            colour.Red,
            colour.Green,
            colour.Blue,
            Opaque
        );

    /// <inheritdoc/>
    public void HideGames()
    {
        Natives.Call(Hash.HIDE_HUD_AND_RADAR_THIS_FRAME);
        Natives.Call(Hash.THEFEED_HIDE_THIS_FRAME);
    }
}
