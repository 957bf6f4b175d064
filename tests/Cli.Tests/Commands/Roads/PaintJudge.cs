using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Cli.Tests.Commands.Roads;

/// <summary>
/// Compares a table of measured paint with the lines that the simulated game painted. Both are taken as lines on the ground: the measured
/// ones are sampled every metre, and each sample is compared with the nearest painted line.
/// </summary>
internal sealed class PaintJudge
{
    /// <summary>
    /// A sample farther than this from all paint is on a false line, metres: half the distance of the nearest real lines. Such a sample
    /// counts as off by this distance, with wrong style and colour.
    /// </summary>
    private const double MaxDistance = 0.5;

    private const double Step = 1;

    private ILookup<(int X, int Y), (PaintedLine Line, int Segment)> _paint = null!;
    private readonly List<double> _errors = [];

    /// <summary>Where false stretches end: one that begins there is of the same line.</summary>
    private readonly List<Vector3D> _falseEnds = [];
    private int _rightStyles;
    private int _rightColours;

    public double RoadMetres { get; private set; }

    public double LineMetres => Step * _errors.Count;

    public int FalseLines { get; private set; }

    public double MedianError => Quantile(0.5);

    public double Error95 => Quantile(0.95);

    public double StyleShare => (double)_rightStyles / _errors.Count;

    public double ColourShare => (double)_rightColours / _errors.Count;

    public double FalseLinesPerKm => FalseLines / (RoadMetres / 1000);

    public List<string> Faults { get; } = [];

    /// <summary>Adds a table and what is painted on its roads.</summary>
    public void Judge(PaintTable table, RoadCurves curves, IEnumerable<PaintedLine> painted)
    {
        _paint = painted
            .SelectMany(line => Enumerable.Range(0, line.Points.Count - 1).Select(i => (line, i)))
            .ToLookup(segment => CellOf(segment.line.Points[segment.i].World));
        _falseEnds.Clear();
        foreach (LinkPaint link in table.Links)
        {
            RoadMetres += link.SeenTo - link.SeenFrom;
            link.Lines.ToList().ForEach(line => Judge(link.Link, line, curves.Of(link.Link)));
        }
    }

    public override string ToString() =>
        FormattableString.Invariant(
            $"{RoadMetres / 1000:0.00} km of road, {LineMetres / 1000:0.00} km of lines: error {100 * MedianError:0.0} cm median, "
        )
        + FormattableString.Invariant(
            $"{100 * Error95:0.0} cm 95 %; style {StyleShare:0.0000}, colour {ColourShare:0.0000}, false lines {FalseLines}"
        );

    private void Judge(int link, LinePaint line, RoadCurve curve)
    {
        int samples = Math.Max(1, (int)((line.ToStation - line.FromStation) / Step));
        int missed = 0;
        double worst = 0;
        for (int i = 0; i < samples; i++)
        {
            double station = line.FromStation + ((i + 0.5) * (line.ToStation - line.FromStation) / samples);
            Vector3D place = curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station));
            if (Nearest(place) is not { } nearest)
            {
                missed++;
                _errors.Add(MaxDistance);
                continue;
            }

            worst = Math.Max(worst, nearest.Distance);
            _errors.Add(nearest.Distance);
            _rightStyles += nearest.Paint.Style == line.Paint.Style ? 1 : 0;
            _rightColours += nearest.Paint.Colour == line.Paint.Colour ? 1 : 0;
            if (i == samples / 2 && (nearest.Paint.Style, nearest.Paint.Colour) != (line.Paint.Style, line.Paint.Colour))
            {
                Faults.Add(FormattableString.Invariant($"link {link} at {place}: {line}, but {nearest.Paint}"));
            }
        }

        if (2 * missed > samples)
        {
            Vector3D[] ends =
            [
                .. new[] { line.FromStation, line.ToStation }.Select(station =>
                    curve.PointBeside(curve.ParameterAt(station), line.OffsetAt(station))
                ),
            ];
            bool isContinued = _falseEnds.Exists(known => ends.Any(end => (end - known).Length < Step));
            FalseLines += isContinued ? 0 : 1;
            _falseEnds.AddRange(ends);
            Faults.Add(FormattableString.Invariant($"link {link}: no paint at {line}"));
        }
        else if (worst > 0.1)
        {
            Faults.Add(FormattableString.Invariant($"link {link}: {worst:0.00} m off {line}"));
        }
    }

    private (double Distance, MarkingPaint Paint)? Nearest(Vector3D place)
    {
        (double, MarkingPaint)? found = null;
        double least = MaxDistance;
        (int x, int y) = CellOf(place);
        for (int i = 0; i < 9; i++)
        {
            foreach ((PaintedLine line, int segment) in _paint[(x + (i % 3) - 1, y + (i / 3) - 1)])
            {
                double distance = Distance(place, line.Points[segment].World, line.Points[segment + 1].World);
                if (distance < least)
                {
                    least = distance;
                    found = (distance, line.Paint);
                }
            }
        }

        return found;
    }

    private static double Distance(Vector3D place, Vector3D a, Vector3D b)
    {
        var along = new Vector2D(b.X - a.X, b.Y - a.Y);
        var apart = new Vector2D(place.X - a.X, place.Y - a.Y);
        double part = Math.Clamp(apart.Dot(along) / along.Dot(along), 0, 1);
        return (apart - (along * part)).Length;
    }

    private double Quantile(double share)
    {
        double[] sorted = [.. _errors.Order()];
        return sorted.Length == 0 ? double.NaN : sorted[(int)(share * (sorted.Length - 1))];
    }

    private static (int X, int Y) CellOf(Vector3D place) => ((int)Math.Floor(place.X), (int)Math.Floor(place.Y));
}
