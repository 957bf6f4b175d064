using System.Collections.Generic;
using Harvester.Geometry.Calibration;

namespace Harvester.Capture.Ports;

/// <summary>
/// Draws balls into the game's world, by which the camera is calibrated. They are of one bright colour that the world hardly has, magenta
/// say, and no lamp changes it.
/// </summary>
public interface IMarkers
{
    /// <summary>Shows these balls and no others, in every picture from the next tick on.</summary>
    /// <param name="markers">Centres and radii; where a ball is expected in the picture is no business of the game's.</param>
    void Show(IReadOnlyList<PlannedMarker> markers);

    /// <summary>Shows no ball any more. Again is no harm.</summary>
    void Clear();
}
