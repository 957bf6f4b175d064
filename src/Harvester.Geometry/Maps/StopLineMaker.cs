using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// Makes the stop lines of a map: the painted ones, and at the ends of the lanes that lead into a junction where the road data or a light
/// or sign says that traffic waits and no line was seen.
/// </summary>
/// <param name="map">The map.</param>
internal sealed class StopLineMaker(LaneNetwork map)
{
    /// <summary>
    /// A painted line belongs to lanes that it crosses, or that end at most this far before it, metres: junctions of the map may begin
    /// before their painted lines.
    /// </summary>
    private const double MaxBeyond = 8;

    /// <summary>A line belongs to a lane whose middle passes its end by at most this, metres.</summary>
    private const double MaxAside = 0.5;

    /// <summary>A line is square to the lanes to within this cosine: 37 degrees.</summary>
    private const double MaxSkew = 0.6;

    /// <summary>Lanes farther above or below are those of another road, metres.</summary>
    private const double SameLevel = 3;

    /// <summary>The node of a stop line and the painted line lie on a link that ends at most this far before the junction, metres.</summary>
    private const double MaxFromJunction = 45;

    private const RoadNodeFlags Waits = RoadNodeFlags.TrafficLight | RoadNodeFlags.GiveWay;

    private readonly Dictionary<string, int> _names = new(StringComparer.Ordinal);

    /// <summary>Makes the stop lines, and notes them in lanes and signals.</summary>
    public List<MapStopLine> Make(IEnumerable<(PaintedMark Mark, MapSource Source)> marks)
    {
        var lines = new List<MapStopLine>();
        foreach ((PaintedMark mark, MapSource source) in marks.Where(static mark => mark.Mark.Kind == MarkKind.StopLine))
        {
            if (Painted(mark, source) is { } line)
            {
                lines.Add(line);
                Note(line);
            }
        }

        ILookup<LaneApproach, MapSignal> signals = map
            .Signals.Where(static signal => signal.Lanes.Count > 0)
            .ToLookup(signal => map.ApproachOf(signal.Lanes[0])!);
        foreach (LaneApproach approach in map.Approaches)
        {
            MapStopLine? line = PaintedBefore(approach);
            if (line is null && (signals.Contains(approach) || HasStopNode(approach)))
            {
                line = new MapStopLine(approach.Id + "/stop", approach.Left, approach.Right, approach.Lanes, MapSource.Derived);
                lines.Add(line);
                Note(line);
            }

            foreach (MapSignal signal in signals[approach])
            {
                signal.StopLine = line;
            }
        }

        return lines;
    }

    private static void Note(MapStopLine line)
    {
        foreach (MapLane lane in line.Lanes)
        {
            lane.StopLine ??= line;
        }
    }

    private MapStopLine? Painted(PaintedMark mark, MapSource source)
    {
        (Vector3D one, Vector3D other) = Axis(mark.Corners);
        Vector3D middle = (one + other) * 0.5;
        double half = new Vector2D(other.X - one.X, other.Y - one.Y).Length / 2;
        MapLane[] lanes =
        [
            .. map
                .Index.Near(middle, half + MaxBeyond)
                .Where(lane => lane.Junction is null && Crosses(lane, one, other))
                .OrderBy(lane => lane.Index),
        ];
        if (lanes.Length == 0)
        {
            return null;
        }

        // The lanes of one road and direction: those of the lane that passes nearest to the line's middle.
        MapLane nearest = lanes.OrderBy(lane => LanePiece.NearestOf(lane, middle).FromMiddle).First();
        lanes = [.. lanes.Where(lane => lane.Link == nearest.Link && lane.IsForward == nearest.IsForward)];
        Vector2D along = LanePiece.NearestOf(nearest, middle).Direction;
        bool isOneLeft = along.Cross(new Vector2D(one.X - other.X, one.Y - other.Y)) > 0;
        string name = $"{MapNames.Side(nearest)}/line";
        int count = _names.TryGetValue(name, out int before) ? before + 1 : 1;
        _names[name] = count;
        string id = count == 1 ? name : FormattableString.Invariant($"{name}.{count}");
        return new MapStopLine(id, isOneLeft ? one : other, isOneLeft ? other : one, lanes, source);
    }

    private static bool Crosses(MapLane lane, Vector3D one, Vector3D other)
    {
        var across = new Vector2D(other.X - one.X, other.Y - one.Y);
        LanePiece place = LanePiece.NearestOf(lane, (one + other) * 0.5);
        double length = place.Direction.Length * across.Length;
        return length > 0
            && Math.Abs(place.Direction.Dot(across)) <= MaxSkew * length
            && place.Beyond <= (place.IsPast ? MaxBeyond : 0)
            && Math.Abs(place.Height) <= SameLevel
            && place.FromMiddle <= (across.Length / 2) + MaxAside;
    }

    /// <summary>The ends of the middle line of an outline: between the middles of the two sides that are farthest apart.</summary>
    private static (Vector3D One, Vector3D Other) Axis(IReadOnlyList<Vector3D> corners)
    {
        Vector3D[] middles = [.. Enumerable.Range(0, corners.Count).Select(i => (corners[i] + corners[(i + 1) % corners.Count]) * 0.5)];
        return (
            from i in Enumerable.Range(0, middles.Length)
            from j in Enumerable.Range(i + 1, middles.Length - i - 1)
            orderby (middles[i] - middles[j]).Length descending
            select (middles[i], middles[j])
        ).First();
    }

    /// <summary>The painted line nearest before a junction, on the road to it or where that continues.</summary>
    private static MapStopLine? PaintedBefore(LaneApproach approach)
    {
        foreach ((MapLane lane, _) in approach.Back(MaxFromJunction))
        {
            MapStopLine? line = SideOf(lane).Select(static beside => beside.StopLine).FirstOrDefault(static found => found is not null);
            if (line is not null && line.Source != MapSource.Derived)
            {
                return line;
            }
        }

        return null;
    }

    private static IEnumerable<MapLane> SideOf(MapLane lane)
    {
        for (MapLane? beside = lane; beside is not null; beside = beside.RightNeighbour)
        {
            yield return beside;
        }
    }

    /// <summary>Whether a node of the road before a junction says that its traffic waits.</summary>
    private bool HasStopNode(LaneApproach approach)
    {
        if (map.ArmsOf(approach.Junction) < SignalLanes.MinArms)
        {
            return false;
        }

        foreach ((MapLane lane, _) in approach.Back(MaxFromJunction))
        {
            RoadLink link = map.Network.Links[lane.Link!.Value];
            if (((map.Network.Nodes[link.From].Flags | map.Network.Nodes[link.To].Flags) & Waits) != 0)
            {
                return true;
            }
        }

        return false;
    }
}
