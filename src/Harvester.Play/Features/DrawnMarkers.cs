using Harvester.Capture.Ports;
using Harvester.Geometry.Calibration;

namespace Harvester.Play.Features;

/// <summary>Balls for the calibration. The game draws a ball for one frame only, so all of them are drawn in each tick.</summary>
/// <param name="display">Draws the balls.</param>
public sealed class DrawnMarkers(IDisplay display) : IMarkers, IFeature
{
    private static readonly Colour Magenta = new(255, 0, 255);
    private IReadOnlyList<PlannedMarker> _markers = [];

    /// <inheritdoc/>
    public string Name => "The markers";

    /// <inheritdoc/>
    public bool IsOn => _markers.Count > 0;

    /// <inheritdoc/>
    public void Show(IReadOnlyList<PlannedMarker> markers) => _markers = markers;

    /// <inheritdoc/>
    public void Clear() => _markers = [];

    /// <inheritdoc/>
    public void Tick()
    {
        foreach (PlannedMarker marker in _markers)
        {
            display.Ball(marker.Centre, marker.RadiusMetres, Magenta);
        }
    }

    /// <inheritdoc/>
    public void Stop() => Clear();
}
