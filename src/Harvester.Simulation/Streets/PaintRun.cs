using System;
using System.Collections.Generic;
using Harvester.Geometry.Lanes;

namespace Harvester.Simulation.Streets;

/// <summary>A line along a road from where its paint begins to where it ends.</summary>
/// <param name="Facets">The asphalt of the road.</param>
/// <param name="Marking">What is painted.</param>
/// <param name="Pieces">The painted pieces, metres along the road; an unbroken line is one.</param>
internal sealed record PaintRun(RoadFacets Facets, Marking Marking, IReadOnlyList<(double From, double To)> Pieces)
{
    /// <summary>Paint lies this far above the asphalt, metres: enough to be drawn, too little to be seen as height.</summary>
    public const double Height = 0.01;

    /// <summary>
    /// Between points, metres. They lie off the ends of dashes by half of it, and off the end of the line by a quarter, where it is plain
    /// whether there is paint.
    /// </summary>
    private const double Step = 0.5;

    private const double DashLength = 3;
    private const double DashPeriod = 9;

    /// <summary>An unbroken line is painted, or left out, metre by metre.</summary>
    private const double Metre = 1;

    /// <summary>The lines of a road: none in the junctions at its ends, and none where another road's asphalt takes their place.</summary>
    public static IEnumerable<PaintRun> Of(Road road, Asphalt asphalt)
    {
        RoadFacets facets = asphalt.Of(road);
        foreach (Marking marking in road.Layout.Markings())
        {
            double end = road.Length - road.EndTrim;
            double period = marking.IsDashed ? DashPeriod : Metre;
            List<(double From, double To)> pieces = [];
            for (double from = road.StartTrim; from < end; from += period)
            {
                double to = Math.Min(from + (marking.IsDashed ? DashLength : Metre), end);
                if (IsFree(road, asphalt, marking, from, to))
                {
                    Add(pieces, from, to);
                }
                else if (pieces.Count > 0)
                {
                    yield return new PaintRun(facets, marking, pieces);
                    pieces = [];
                }
            }

            if (pieces.Count > 0)
            {
                yield return new PaintRun(facets, marking, pieces);
            }
        }
    }

    /// <summary>Its middle in the world.</summary>
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

    /// <summary>Whether nothing takes a piece's place, from its one end to its other.</summary>
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

    /// <summary>Pieces that meet become one.</summary>
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
