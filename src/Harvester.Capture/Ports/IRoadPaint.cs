using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;

namespace Harvester.Capture.Ports;

/// <summary>The paint on roads, reported by the game or measured.</summary>
public interface IRoadPaint
{
    /// <summary>Whether all paint is known. Measured paint is not: where there is no line, it may not have been seen.</summary>
    bool IsComplete { get; }

    /// <summary>The lines along the roads that lie at least partly within a distance of a position.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IEnumerable<PaintedLine> Near(Vector3D place, double range);

    /// <summary>The stop lines with a corner within a distance of a position.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    IEnumerable<PaintedMark> StopLinesNear(Vector3D place, double range);
}
