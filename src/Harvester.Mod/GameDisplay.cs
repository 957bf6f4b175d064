using Harvester.Capture.Playing;
using Harvester.Geometry;

namespace Harvester.Mod;

/// <summary>Draws by the game's natives.</summary>
internal sealed class GameDisplay : IDisplay
{
    /// <inheritdoc/>
    public void Rectangle(Box2D place, Colour colour) => Natives.DrawRectangle(
        (place.XMin + place.XMax) / 2, (place.YMin + place.YMax) / 2, place.Width, place.Height, colour);

    /// <inheritdoc/>
    public void Text(string text, double left, double top) => Natives.DrawText(text, left, top);

    /// <inheritdoc/>
    public void HideGames()
    {
        Natives.HideHudAndRadar();
        Natives.HideFeed();
    }
}
