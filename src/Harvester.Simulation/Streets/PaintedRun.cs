using Harvester.Geometry.Lanes;

namespace Harvester.Simulation.Streets;

/// <summary>A painted line along a road from the start of its paint to its end.</summary>
/// <param name="Facets">The asphalt of the road.</param>
/// <param name="Marking">The marking.</param>
/// <param name="Pieces">The painted pieces, metres along the road; a solid line has one.</param>
internal sealed record PaintedRun(RoadFacets Facets, Marking Marking, IReadOnlyList<(double From, double To)> Pieces)
{
    /// <summary>
    /// Thickness of the paint on the asphalt, metres: that of a marking. A ray to it is shorter than to the asphalt by this fraction of the
    /// camera's height, at any distance, which single precision tells apart from 1000 m up.
    /// </summary>
    public const double Height = 0.002;

    /// <summary>
    /// Distance between points, metres. They are off the ends of dashes by half of it, and off the end of the line by a quarter, so that it
    /// is clear whether there is paint.
    /// </summary>
    private const double Step = 0.5;

    /// <summary>A solid line is painted, or left out, metre by metre.</summary>
    private const double Metre = 1;

    /// <summary>The lines of a road, except in the junctions at its ends, and where another road's asphalt takes their place.</summary>
    public static IEnumerable<PaintedRun> Of(Road road, Asphalt asphalt)
    {
        RoadFacets facets = asphalt.Of(road);
        foreach (Marking marking in road.Layout.Markings())
        {
            double end = road.Length - road.EndTrim;
            double period = marking.IsDashed ? marking.Sizes.DashPeriod : Metre;
            List<(double From, double To)> pieces = [];
            for (double from = road.StartTrim; from < end; from += period)
            {
                double to = Math.Min(from + (marking.IsDashed ? marking.Sizes.DashLength : Metre), end);
                if (IsFree(road, asphalt, marking, from, to))
                {
                    Add(pieces, from, to);
                }
                else if (pieces.Count > 0)
                {
                    yield return new PaintedRun(facets, marking, pieces);
                    pieces = [];
                }
            }

            if (pieces.Count > 0)
            {
                yield return new PaintedRun(facets, marking, pieces);
            }
        }
    }

    /// <summary>Its centre line in the world.</summary>
    public PaintedLine Line()
    {
        List<LinePoint> points = [PointAt(Pieces[0].From, isPainted: true)];
        double end = Pieces[^1].To;
        int piece = 0;
        for (double distance = Pieces[0].From + (Step / 2); distance < end - (Step / 4); distance += Step)
        {
            while (distance > Pieces[piece].To)
            {
                piece++;
            }

            points.Add(PointAt(distance, isPainted: distance >= Pieces[piece].From));
        }

        points.Add(PointAt(end, isPainted: true));
        return new PaintedLine(Marking.Paint, points);
    }

    /// <summary>Whether nothing else covers a piece, from one end to the other.</summary>
    private static bool IsFree(Road road, Asphalt asphalt, Marking marking, double from, double to)
    {
        int steps = Math.Max(1, (int)Math.Ceiling((to - from) / Metre));
        for (int i = 0; i <= steps; i++)
        {
            if (asphalt.IsAnothers(road, from + ((to - from) * i / steps), marking.Offset, Height))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Adds a piece; adjacent pieces are merged.</summary>
    private static void Add(List<(double From, double To)> pieces, double from, double to)
    {
        if (pieces.Count > 0 && pieces[^1].To >= from)
        {
            pieces[^1] = (pieces[^1].From, to);
        }
        else
        {
            pieces.Add((from, to));
        }
    }

    private LinePoint PointAt(double distance, bool isPainted) =>
        new(Facets.At(distance, Marking.Offset) + (Horizontal.Up * Height), isPainted);
}
