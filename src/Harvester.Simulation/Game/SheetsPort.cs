using Harvester.Capture.Ports;
using Harvester.Geometry.PixelMaps.Coded;

namespace Harvester.Simulation.Game;

/// <summary>Shows sheets in the simulated world.</summary>
internal sealed class SheetsPort(SimulatedGame game) : ISheets
{
    public void Show(IReadOnlyList<ScreenSheet> sheets) => game.Sheets = sheets;

    public void Clear()
    {
        if (game.Sheets.Count > 0)
        {
            game.Sheets = [];
        }
    }
}
