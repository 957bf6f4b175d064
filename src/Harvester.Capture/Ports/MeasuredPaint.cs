using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Capture.Ports;

/// <summary>The paint of roads as it was measured in images.</summary>
public sealed class MeasuredPaint : IRoadPaint
{
    /// <summary>Distance of the points of a line, metres; those of dashes are half of it off at most.</summary>
    private const double Step = 0.5;

    private readonly List<(PaintedLine Line, Vector3D Middle, double Radius)> _lines = [];

    /// <summary>Places the lines of a table in the world.</summary>
    /// <param name="table">The measured lines.</param>
    public MeasuredPaint(PaintTable table)
    {
        if (table is null)
        {
            throw new ArgumentNullException(nameof(table));
        }

        var curves = new RoadCurves(table.Network);
        foreach (LinkPaint link in table.Links)
        {
            foreach (LinePaint line in link.Lines)
            {
                PaintedLine placed = Placed(curves.Of(link.Link), line);
                Vector3D start = placed.Points[0].World;
                Vector3D end = placed.Points[placed.Points.Count - 1].World;
                Vector3D middle = (start + end) * 0.5;
                _lines.Add((placed, middle, placed.Points.Max(point => (point.World - middle).Length)));
            }
        }
    }

    /// <inheritdoc/>
    public IEnumerable<PaintedLine> Near(Vector3D place, double range) =>
        _lines.Where(line => (line.Middle - place).Length <= range + line.Radius).Select(line => line.Line);

    private static PaintedLine Placed(RoadCurve curve, LinePaint line)
    {
        int steps = Math.Max(1, (int)Math.Ceiling((line.ToStation - line.FromStation) / Step));
        var points = new List<LinePoint>(steps + 1);
        for (int i = 0; i <= steps; i++)
        {
            double station = line.FromStation + ((line.ToStation - line.FromStation) * i / steps);
            Vector3D world = curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station));
            points.Add(new LinePoint(world, line.Dashes?.IsPainted(station) ?? true));
        }

        return new PaintedLine(line.Paint, points);
    }
}
