using System.Collections.Generic;
using Harvester.Capture.Ports;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Play.Features;

/// <summary>Sheets on the ground for coded masks. The game draws a sheet for one frame only, so all are drawn in each tick.</summary>
/// <param name="display">Draws the sheets.</param>
public sealed class DrawnSheets(IDisplay display) : ISheets, IFeature
{
    private static readonly Colour Magenta =
        new((byte)ScreenSheet.Colour.X, (byte)ScreenSheet.Colour.Y, (byte)ScreenSheet.Colour.Z);

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
            display.Triangle(sheet.A, sheet.C, sheet.D, Magenta);
        }
    }

    /// <inheritdoc/>
    public void Stop() => Clear();
}
