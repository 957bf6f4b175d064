using Harvester.Geometry;
using Harvester.Geometry.Lanes;

namespace Harvester.Capture.Ports;

/// <summary>The paint on the roads of a game that reports it.</summary>
public interface IRoadPaint
{
    /// <summary>The lines along the roads that lie at least partly within a distance of a position.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IEnumerable<PaintedLine> Near(Vector3D place, double range);
}
