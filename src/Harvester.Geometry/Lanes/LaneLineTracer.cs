using System;
using System.Collections.Generic;

namespace Harvester.Geometry.Lanes;

/// <summary>
/// Traces the markings of all lanes of a stretch of road. A marking goes on from link to link while its number stays; where a road
/// gains or loses a lane, a marking begins or ends.
/// </summary>
public static class LaneLineTracer
{
    /// <summary>Points this close together keep a line within a pixel of the curve from 5 m on, metres.</summary>
    private const double NearStep = 0.5;
    private const double FarStep = 2;
    private const double NearReach = 20;

    /// <summary>A median narrower than this is a painted divide, metres.</summary>
    private const double NoMedian = 0.05;

    /// <summary>Traces the markings.</summary>
    /// <param name="stretch">The road.</param>
    /// <param name="carOffset">The car's place, metres to the right of the centre line.</param>
    /// <param name="from">First station, metres along the road from the car.</param>
    /// <param name="to">Last station.</param>
    public static IReadOnlyList<LaneLine> Trace(RoadStretch stretch, double carOffset, double from, double to)
    {
        Guard.NotNull(stretch, nameof(stretch));
        var lines = new List<LaneLine>();
        var open = new Dictionary<int, (List<Vector3D> Points, bool IsLeft)>();
        double end = Math.Min(to, stretch.EndStation);
        for (double station = Math.Max(from, stretch.StartStation); ; station = Next(station, end))
        {
            StretchPiece piece = stretch.PieceAt(station)!;
            Dictionary<int, double> markings = MarkingsOf(piece);
            CloseAllBut(markings, open, lines);
            double parameter = piece.ParameterAt(station);
            foreach (KeyValuePair<int, double> marking in markings)
            {
                if (!open.TryGetValue(marking.Key, out (List<Vector3D> Points, bool IsLeft) line))
                {
                    line = ([], marking.Value < carOffset);
                    open.Add(marking.Key, line);
                }

                line.Points.Add(piece.PointBeside(parameter, marking.Value));
            }

            if (station >= end)
            {
                break;
            }
        }

        CloseAllBut([], open, lines);
        lines.Sort(static (a, b) => a.Index.CompareTo(b.Index));
        return lines;
    }

    private static double Next(double station, double end) =>
        Math.Min(end, station + (Math.Abs(station) < NearReach ? NearStep : FarStep));

    private static void CloseAllBut(
        Dictionary<int, double> going, Dictionary<int, (List<Vector3D> Points, bool IsLeft)> open, List<LaneLine> lines)
    {
        foreach (int index in new List<int>(open.Keys))
        {
            if (!going.ContainsKey(index))
            {
                if (open[index].Points.Count > 1)
                {
                    lines.Add(new LaneLine(index, open[index].IsLeft, open[index].Points));
                }

                open.Remove(index);
            }
        }
    }

    /// <summary>The markings of a link by their numbers, with their offsets to the right of the centre line as it is driven.</summary>
    private static Dictionary<int, double> MarkingsOf(StretchPiece piece)
    {
        var markings = new Dictionary<int, double>();
        for (int i = 0; i <= piece.Section.LaneCount; i++)
        {
            markings.Add(i, piece.LeftEdge + (i * piece.Section.LaneWidth));
        }

        if (piece.Oncoming is { } oncoming)
        {
            bool hasMedian = piece.LeftEdge + oncoming.LeftEdge > NoMedian;
            for (int i = hasMedian ? 0 : 1; i <= oncoming.Section.LaneCount; i++)
            {
                markings.Add(-i - 1, -(oncoming.LeftEdge + (i * oncoming.Section.LaneWidth)));
            }
        }

        return markings;
    }
}
