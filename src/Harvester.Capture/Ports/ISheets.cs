using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Capture.Ports;

/// <summary>
/// Draws flat sheets in the game's world, in the colour of <see cref="ScreenSheet.Colour"/>, unaffected by lights and without shadows. What
/// is nearer hides them.
/// </summary>
public interface ISheets
{
    /// <summary>Shows these sheets and no others, in every picture from the next tick on.</summary>
    void Show(IReadOnlyList<ScreenSheet> sheets);

    /// <summary>Removes all sheets. Calling it again has no effect.</summary>
    void Clear();
}
