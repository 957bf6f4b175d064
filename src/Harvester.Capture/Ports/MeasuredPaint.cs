using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;

namespace Harvester.Capture.Ports;

/// <summary>The paint of roads as it was measured in images. Safe for any number of threads.</summary>
/// <param name="table">The measured lines.</param>
public sealed class MeasuredPaint(PaintTable table) : IRoadPaint
{
    private readonly PlacedPaint _lines = new(table);

    /// <inheritdoc/>
    public bool IsComplete => false;

    /// <inheritdoc/>
    public IEnumerable<PaintedLine> Near(Vector3D place, double range) => _lines.Near(place, range);

    /// <inheritdoc/>
    public IEnumerable<PaintedMark> StopLinesNear(Vector3D place, double range) =>
        table.Marks.Select(static mark => mark.Mark).Where(mark => mark.Kind == MarkKind.StopLine && mark.IsNear(place, range));
}
