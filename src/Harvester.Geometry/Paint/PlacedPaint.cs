using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The lines of a table in the world. They are placed when they are asked for, so that the lines of a whole map take little memory. Safe
/// for any number of threads.
/// </summary>
public sealed class PlacedPaint
{
    /// <summary>Distance of the points of a line, metres; those of dashes are half of it off at most.</summary>
    private const double Step = 0.5;

    /// <summary>Side of the cells in which stretches are found, metres.</summary>
    private const double Cell = 100;

    private readonly RoadCurves _curves;
    private readonly ILookup<(int X, int Y), (PaintPiece Piece, Vector3D Middle, double Radius)> _pieces;
    private readonly double _maxRadius;

    /// <summary>Prepares the lines of a table.</summary>
    /// <param name="table">The measured lines.</param>
    public PlacedPaint(PaintTable table)
    {
        _curves = new RoadCurves(Guard.NotNull(table, nameof(table)).Network);
        (PaintPiece Piece, Vector3D Middle, double Radius)[] pieces =
        [
            .. PaintPieces.Of(table, _curves).Select(piece => (piece, Middle(piece), Radius(piece.Line))),
        ];
        _pieces = pieces.ToLookup(piece => CellOf(piece.Middle.X, piece.Middle.Y));
        _maxRadius = pieces.Select(static piece => piece.Radius).DefaultIfEmpty().Max();
    }

    /// <summary>The lines that lie at least partly within a distance of a place; of long lines, the stretches that do.</summary>
    /// <param name="place">Metres, world.</param>
    /// <param name="range">Metres; greater than 0.</param>
    public IEnumerable<PaintedLine> Near(Vector3D place, double range)
    {
        List<PaintPiece> near = [.. PiecesNear(place, range).OrderBy(static piece => (piece.Run, piece.Order))];
        int first = 0;
        for (int i = 1; i <= near.Count; i++)
        {
            if (i == near.Count || near[i].Run != near[i - 1].Run || near[i].Order != near[i - 1].Order + 1)
            {
                yield return Placed(near.GetRange(first, i - first));
                first = i;
            }
        }
    }

    private IEnumerable<PaintPiece> PiecesNear(Vector3D place, double range)
    {
        double reach = range + _maxRadius;
        (int fromX, int fromY) = CellOf(place.X - reach, place.Y - reach);
        (int toX, int toY) = CellOf(place.X + reach, place.Y + reach);
        for (int x = fromX; x <= toX; x++)
        {
            for (int y = fromY; y <= toY; y++)
            {
                foreach ((PaintPiece piece, Vector3D middle, double radius) in _pieces[(x, y)])
                {
                    if ((middle - place).Length <= range + radius)
                    {
                        yield return piece;
                    }
                }
            }
        }
    }

    private Vector3D Middle(PaintPiece piece)
    {
        double station = (piece.Line.FromStation + piece.Line.ToStation) / 2;
        RoadCurve curve = _curves.Of(piece.Link);
        return curve.PointBeside(curve.ParameterAt(station), piece.Line.OffsetAt(station));
    }

    /// <summary>
    /// An upper bound of the distance of a stretch's points from its middle: twice its half length, which a line on the outside of a bend
    /// does not exceed, and its change of offset.
    /// </summary>
    private static double Radius(LinePaint line) => line.ToStation - line.FromStation + Math.Abs(line.ToOffset - line.FromOffset);

    private static (int X, int Y) CellOf(double x, double y) => ((int)Math.Floor(x / Cell), (int)Math.Floor(y / Cell));

    private PaintedLine Placed(List<PaintPiece> pieces)
    {
        var points = new List<LinePoint>();
        foreach (PaintPiece piece in pieces)
        {
            LinePaint line = piece.Line;
            RoadCurve curve = _curves.Of(piece.Link);
            int steps = Math.Max(1, (int)Math.Ceiling((line.ToStation - line.FromStation) / Step));

            // The first point of a further stretch is the last one of the stretch before.
            for (int i = points.Count == 0 ? 0 : 1; i <= steps; i++)
            {
                int at = piece.IsReversed ? steps - i : i;
                double station = line.FromStation + ((line.ToStation - line.FromStation) * at / steps);
                Vector3D world = curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station));
                points.Add(new LinePoint(world, line.Dashes?.IsPainted(station) ?? true));
            }
        }

        return new PaintedLine(pieces[0].Line.Paint, points) { SigmaMetres = pieces.Max(static piece => piece.Line.SigmaMetres) };
    }
}
