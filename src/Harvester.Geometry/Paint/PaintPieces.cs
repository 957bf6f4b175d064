using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>Joins the stretches of a table to the lines that they are parts of.</summary>
internal sealed class PaintPieces
{
    /// <summary>
    /// Stretches of the same paint whose ends lie this near to each other are one line, metres: the curves of two links meet, and at a bend
    /// between them lines to their side do not quite.
    /// </summary>
    private const double SamePlace = 0.3;

    private readonly List<(int Link, LinePaint Line, Vector3D From, Vector3D To)> _stretches;
    private readonly ILookup<(int X, int Y, MarkingPaint Paint), (int Stretch, bool IsTo)> _ends;
    private readonly bool[] _isTaken;

    private PaintPieces(PaintTable table, RoadCurves curves)
    {
        _stretches =
        [
            .. table.Links.SelectMany(link =>
                link.Lines.Select(line => (link.Link, line, At(curves, link.Link, line, 0), At(curves, link.Link, line, 1)))
            ),
        ];
        _ends = Enumerable
            .Range(0, _stretches.Count)
            .SelectMany(static i => new[] { (Stretch: i, IsTo: false), (Stretch: i, IsTo: true) })
            .ToLookup(end => CellOf(EndOf(end.Stretch, end.IsTo), _stretches[end.Stretch].Line.Paint));
        _isTaken = new bool[_stretches.Count];
    }

    /// <summary>The stretches of a table, each with its place on its line.</summary>
    public static IEnumerable<PaintPiece> Of(PaintTable table, RoadCurves curves) => new PaintPieces(table, curves).Joined();

    private IEnumerable<PaintPiece> Joined()
    {
        int run = 0;
        for (int i = 0; i < _stretches.Count; i++)
        {
            if (_isTaken[i])
            {
                continue;
            }

            _isTaken[i] = true;
            List<(int Stretch, bool IsReversed)> before = Beyond(i, atEnd: false);
            before.Reverse();
            int order = 0;
            foreach (
                (int stretch, bool isReversed) in before
                    .Select(static piece => (piece.Stretch, !piece.IsReversed))
                    .Concat([(i, false)])
                    .Concat(Beyond(i, atEnd: true))
            )
            {
                yield return new PaintPiece(run, order++, _stretches[stretch].Link, _stretches[stretch].Line, isReversed);
            }

            run++;
        }
    }

    /// <summary>The stretches beyond an end of one, outwards; reversed if their end comes before their start.</summary>
    private List<(int Stretch, bool IsReversed)> Beyond(int stretch, bool atEnd)
    {
        var found = new List<(int Stretch, bool IsReversed)>();
        Vector3D end = EndOf(stretch, atEnd);
        MarkingPaint paint = _stretches[stretch].Line.Paint;
        while (Nearest(end, paint) is { } next)
        {
            _isTaken[next.Stretch] = true;
            found.Add((next.Stretch, next.IsTo));
            end = EndOf(next.Stretch, !next.IsTo);
        }

        return found;
    }

    private (int Stretch, bool IsTo)? Nearest(Vector3D place, MarkingPaint paint)
    {
        (int Stretch, bool IsTo)? nearest = null;
        double least = SamePlace;
        (int x, int y, _) = CellOf(place, paint);
        for (int i = 0; i < 9; i++)
        {
            foreach ((int stretch, bool isTo) in _ends[(x + (i % 3) - 1, y + (i / 3) - 1, paint)])
            {
                double distance = (EndOf(stretch, isTo) - place).Length;
                if (!_isTaken[stretch] && distance <= least)
                {
                    (nearest, least) = ((stretch, isTo), distance);
                }
            }
        }

        return nearest;
    }

    private Vector3D EndOf(int stretch, bool isTo) => isTo ? _stretches[stretch].To : _stretches[stretch].From;

    private static (int X, int Y, MarkingPaint Paint) CellOf(Vector3D place, MarkingPaint paint) =>
        ((int)Math.Floor(place.X), (int)Math.Floor(place.Y), paint);

    private static Vector3D At(RoadCurves curves, int link, LinePaint line, double part)
    {
        double station = line.FromStation + (part * (line.ToStation - line.FromStation));
        return curves.Of(link).PointBeside(curves.Of(link).ParameterAt(station), line.OffsetAt(station));
    }
}
