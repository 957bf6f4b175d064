using Harvester.Capture.Ports;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Play.Features;

/// <summary>
/// Sheets of the screens behind objects, for masks from photographs. The game draws a sheet for one frame only, so all are drawn in each
/// tick. It draws a triangle from one side only, so each is drawn twice.
/// </summary>
/// <param name="display">Draws the sheets.</param>
public sealed class DrawnSheets(IDisplay display) : ISheets, IFeature
{
    private static readonly Colour Magenta = new((byte)ScreenSheet.Colour.X, (byte)ScreenSheet.Colour.Y, (byte)ScreenSheet.Colour.Z);

    private IReadOnlyList<ScreenSheet> _sheets = [];

    /// <inheritdoc/>
    public string Name => "The sheets";

    /// <inheritdoc/>
    public bool IsOn => _sheets.Count > 0;

    /// <inheritdoc/>
    public void Show(IReadOnlyList<ScreenSheet> sheets) => _sheets = sheets;

    /// <inheritdoc/>
    public void Clear() => _sheets = [];

    /// <inheritdoc/>
    public void Tick()
    {
        foreach (ScreenSheet sheet in _sheets)
        {
            display.Triangle(sheet.A, sheet.B, sheet.C, Magenta);
            display.Triangle(sheet.A, sheet.C, sheet.B, Magenta);
            display.Triangle(sheet.A, sheet.C, sheet.D, Magenta);
            display.Triangle(sheet.A, sheet.D, sheet.C, Magenta);
        }
    }

    /// <inheritdoc/>
    public void Stop() => Clear();
}
