using Harvester.Geometry.Calibration;

namespace Harvester.Capture.Ports;

/// <summary>
/// Draws balls in the game's world for the calibration of the camera. They have one bright colour that is rare in the world, such as
/// magenta, and are unaffected by lights.
/// </summary>
public interface IMarkers
{
    /// <summary>Shows these balls and no others, in every picture from the next tick on.</summary>
    /// <param name="markers">Centres and radii; the expected pixels are ignored.</param>
    void Show(IReadOnlyList<PlannedMarker> markers);

    /// <summary>Removes all balls. Calling it again has no effect.</summary>
    void Clear();
}
