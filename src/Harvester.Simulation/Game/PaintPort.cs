using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;

namespace Harvester.Simulation.Game;

/// <summary>The lines that the world was painted with.</summary>
internal sealed class PaintPort(SimulatedGame game) : IRoadPaint
{
    public bool IsComplete => true;

    public IEnumerable<PaintedLine> Near(Vector3D place, double range) => game.World.Paint.Where(line => IsNear(line, place, range));

    public IEnumerable<PaintedMark> StopLinesNear(Vector3D place, double range) =>
        game.World.Marks.Where(mark => mark.Kind == MarkKind.StopLine && mark.IsNear(place, range));

    /// <summary>Points are close together, so the distance to one point shows how many of the next can be skipped.</summary>
    private static bool IsNear(PaintedLine line, Vector3D place, double range)
    {
        int i = 0;
        while (i < line.Points.Count)
        {
            double beyond = (line.Points[i].World - place).Length - range;
            if (beyond <= 0)
            {
                return true;
            }

            i += 1 + (int)beyond;
        }

        return false;
    }
}
