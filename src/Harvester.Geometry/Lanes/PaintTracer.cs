namespace Harvester.Geometry.Lanes;

/// <summary>Finds the painted lines that mark the boundaries of a road's lanes, and gives them the numbers of these.</summary>
public static class PaintTracer
{
    /// <summary>
    /// Paint farther than this from every boundary marks something else, metres; edge lines are painted a little inside the edge.
    /// </summary>
    private const double MaxBoundaryDistance = 1;

    /// <summary>
    /// Cosine of the maximum angle between paint and its boundary, 30 degrees; paint at a larger angle belongs to another road.
    /// </summary>
    private const double MinAlong = 0.87;

    /// <summary>Maximum width of a carriageway, metres, added to the reach along the road.</summary>
    private const double MaxLateralDistance = 50;

    /// <summary>Tolerance for steps between points, which are sums of smaller ones, metres.</summary>
    private const double Rounding = 1e-6;

    /// <summary>Traces the paint. Each line ends where its paint ends and passes through the points that describe the paint.</summary>
    /// <param name="stretch">The road.</param>
    /// <param name="carOffset">The car's position, metres to the right of the centre line.</param>
    /// <param name="from">First station, metres along the road from the car.</param>
    /// <param name="to">Last station.</param>
    /// <param name="paint">The painted lines around the car.</param>
    public static IReadOnlyList<LaneLine> Trace(
        RoadStretch stretch,
        double carOffset,
        double from,
        double to,
        IEnumerable<PaintedLine> paint
    )
    {
        Guard.NotNull(stretch, nameof(stretch));
        var lines = new List<LaneLine>();
        foreach (PaintedLine painted in Guard.NotNull(paint, nameof(paint)))
        {
            lines.AddRange(
                Along(stretch, carOffset, from, to, painted)
                    .Select(line => line with { Paint = painted.Paint, SigmaMetres = painted.SigmaMetres })
            );
        }

        return [.. lines.OrderBy(line => line.Index)];
    }

    private static IReadOnlyList<LaneLine> Along(RoadStretch stretch, double carOffset, double from, double to, PaintedLine painted)
    {
        var runs = new LineRuns();
        List<(LinePoint Point, StretchPlace? Place)> located =
        [
            .. Thinned(painted.Points, stretch.PointAt(0), to).Select(point => (point, stretch.Locate(point.World))),
        ];
        for (int i = 0; i < located.Count; i++)
        {
            (LinePoint point, StretchPlace? place) = located[i];

            // Direction of the paint at a point: the difference of its neighbours, one-sided at the ends.
            Vector3D along = located[Math.Min(i + 1, located.Count - 1)].Point.World - located[Math.Max(i - 1, 0)].Point.World;
            if (place is { } there && there.Station >= from && there.Station <= to && BoundaryAt(there, along) is { } index)
            {
                // Paint that changes to another boundary, leaves the stretch or turns away ends its line; what follows begins a new one.
                runs.EndAllBut([index]);
                runs.Add(index, there.Offset < carOffset, point);
            }
            else
            {
                runs.EndAllBut([]);
            }
        }

        return [.. runs.Lines().Select(line => NearestFirst(stretch, line))];
    }

    /// <summary>The points within reach of a position, thinned to the spacing of boundary points; both ends are kept.</summary>
    private static IEnumerable<LinePoint> Thinned(IReadOnlyList<LinePoint> points, Vector3D place, double reach)
    {
        double since = double.PositiveInfinity;
        for (int i = 0; i < points.Count; i++)
        {
            double distance = (points[i].World - place).Length;
            since += i > 0 ? (points[i].World - points[i - 1].World).Length : 0;
            bool isEnd = i == points.Count - 1;
            if (distance <= reach + MaxLateralDistance && (isEnd || since >= LaneLineTracer.StepAt(distance) - Rounding))
            {
                since = 0;
                yield return points[i];
            }
        }
    }

    private static int? BoundaryAt(StretchPlace place, Vector3D along)
    {
        Vector2D road = place.Piece.DirectionAt(place.Piece.ParameterAt(place.Station));
        var paint = new Vector2D(along.X, along.Y);

        // |cos| of the angle between road and paint, without dividing by the paint's length.
        if (Math.Abs(road.Dot(paint)) < MinAlong * paint.Length)
        {
            return null;
        }

        int? nearest = null;
        double least = MaxBoundaryDistance;
        foreach (KeyValuePair<int, double> boundary in place.Piece.BoundariesAt(place.Station))
        {
            double apart = Math.Abs(boundary.Value - place.Offset);
            if (apart <= least)
            {
                least = apart;
                nearest = boundary.Key;
            }
        }

        return nearest;
    }

    private static LaneLine NearestFirst(RoadStretch stretch, LaneLine line)
    {
        double first = stretch.Locate(line.Points[0].World)!.Value.Station;
        double last = stretch.Locate(line.Points[line.Points.Count - 1].World)!.Value.Station;
        return first <= last ? line : line with { Points = [.. line.Points.Reverse()] };
    }
}
