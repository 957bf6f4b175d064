using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Capture.Ports;

/// <summary>What is painted on the roads of a game that tells it.</summary>
public interface IRoadPaint
{
    /// <summary>The lines along the roads of which some part lies within a distance of a place.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IEnumerable<PaintedLine> Near(Vector3D place, double range);
}
