using Harvester.Capture.Ports;
using Harvester.Geometry.Calibration;

namespace Harvester.Simulation.Game;

/// <summary>Shows balls in the simulated world.</summary>
internal sealed class MarkersPort(SimulatedGame game) : IMarkers
{
    public void Show(IReadOnlyList<PlannedMarker> markers) =>
        game.Markers = game.Quirks.MaxMarkers is { } most ? [.. markers.Take(most)] : markers;

    public void Clear()
    {
        if (game.Markers.Count > 0)
        {
            game.Markers = [];
        }
    }
}
