using Harvester.Geometry.Lanes;

namespace Harvester.Geometry.Maps;

/// <summary>Finds the painted line nearest to a place.</summary>
internal sealed class KnownPaint
{
    /// <summary>Side of the cells, metres.</summary>
    private const double Cell = 8;

    private readonly GroundGrid<(int Line, int Piece)> _pieces = new(Cell);
    private readonly IReadOnlyList<PaintedLine> _lines;

    public KnownPaint(IReadOnlyList<PaintedLine> lines)
    {
        _lines = lines;
        for (int line = 0; line < lines.Count; line++)
        {
            for (int piece = 1; piece < lines[line].Points.Count; piece++)
            {
                (Vector3D a, Vector3D b) = (lines[line].Points[piece - 1].World, lines[line].Points[piece].World);
                _pieces.Add((line, piece), new Box2D(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Max(a.X, b.X), Math.Max(a.Y, b.Y)));
            }
        }
    }

    /// <summary>The paint of the line nearest to a place on the ground; null if there is none within a distance at its level.</summary>
    public MarkingPaint? Nearest(Vector3D place, double maxDistance, double sameLevel)
    {
        MarkingPaint? nearest = null;
        double least = maxDistance;
        foreach ((int line, int piece) in _pieces.Near(place.X, place.Y, maxDistance))
        {
            Vector3D a = _lines[line].Points[piece - 1].World;
            Vector3D along = _lines[line].Points[piece].World - a;
            double square = (along.X * along.X) + (along.Y * along.Y);
            Vector3D to = place - a;
            double t = square > 0 ? Math.Max(0, Math.Min(1, ((to.X * along.X) + (to.Y * along.Y)) / square)) : 0;
            Vector3D apart = to - (along * t);
            double distance = new Vector2D(apart.X, apart.Y).Length;
            if (distance <= least && Math.Abs(apart.Z) <= sameLevel)
            {
                (nearest, least) = (_lines[line].Paint, distance);
            }
        }

        return nearest;
    }
}
