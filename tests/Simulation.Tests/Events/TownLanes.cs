using Harvester.Geometry;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Events;

/// <summary>
/// The lanes of the town, as strips of their width: the nearest points by brute force. Its traffic drives on their middle; where they end
/// for junctions, docs/maps.md says.
/// </summary>
internal sealed class TownLanes
{
    private const double Cell = 20;
    private const double Level = 3;
    private const double Rounding = 1e-6;
    private const double Step = 0.5;

    private readonly Dictionary<(int X, int Y), List<TownLane>> _cells = [];
    private readonly TownJunctions _junctions;

    public TownLanes(Site site, TownJunctions junctions)
    {
        _junctions = junctions;
        foreach (TownLane lane in site.Lanes.Paths.Select(path => path.Road is null ? Way(path) : OfRoad(path)))
        {
            foreach ((int x, int y) in lane.Points.Select(CellOf).Distinct())
            {
                for (int i = -1; i <= 1; i++)
                {
                    for (int j = -1; j <= 1; j++)
                    {
                        if (!_cells.TryGetValue((x + i, y + j), out List<TownLane>? lanes))
                        {
                            _cells.Add((x + i, y + j), lanes = []);
                        }

                        if (!lanes.Contains(lane))
                        {
                            lanes.Add(lane);
                        }
                    }
                }
            }
        }
    }

    private TownLane OfRoad(LanePath path)
    {
        Road road = path.Road!;
        double start = _junctions.Of(new RoadArm(road, AtStart: true));
        double end = road.Length - _junctions.Of(new RoadArm(road, AtStart: false));
        return new TownLane(
            _junctions.IsInside(road) ? null : road,
            path.IsForward,
            path.Lane,
            path.IsForward ? Middle(path, start, end) : Middle(path, end, start),
            road.Layout.LaneWidth,
            road.Layout.LaneWidth
        );
    }

    /// <summary>The way from where one lane ends to where the other begins: what the traffic drives between, longer or shorter.</summary>
    private TownLane Way(LanePath path)
    {
        (LanePath from, LanePath to) = (path.Previous[0], path.Next[0]);
        var entry = new RoadArm(from.Road!, AtStart: !from.IsForward);
        var exit = new RoadArm(to.Road!, AtStart: to.IsForward);
        var entryLine = new TownLine(path.Junction!, entry, HasLight: false, HasStopSign: false, _junctions.Of(entry));
        var exitLine = new TownLine(path.Junction!, exit, HasLight: false, HasStopSign: false, _junctions.Of(exit));
        IEnumerable<Vector3D> driven = Middle(from, entry.DistanceAt(Math.Max(entry.Trim, entryLine.At)), entry.DistanceAt(entry.Trim))
            .Concat(path.Line.Points)
            .Concat(Middle(to, exit.DistanceAt(exit.Trim), exit.DistanceAt(Math.Max(exit.Trim, exitLine.At))))
            .Where(point => entryLine.Of((point.X, point.Y)).Past > 0 && exitLine.Of((point.X, point.Y)).Past > 0);
        return new TownLane(
            null,
            isForward: true,
            path.Lane,
            [At(from, entry.DistanceAt(entryLine.At)), .. driven, At(to, exit.DistanceAt(exitLine.At))],
            from.Road!.Layout.LaneWidth,
            to.Road!.Layout.LaneWidth
        );
    }

    private static Vector3D At(LanePath lane, double distance) =>
        lane.Road!.Curve.OffsetAt(distance, lane.Road.Layout.LaneCentre(lane.IsForward, lane.Lane));

    /// <summary>The middle of a lane between two distances along its road.</summary>
    private static Vector3D[] Middle(LanePath lane, double from, double to)
    {
        int steps = (int)Math.Ceiling(Math.Abs(to - from) / Step);
        return steps == 0 ? [] : [.. Enumerable.Range(0, steps + 1).Select(i => At(lane, from + ((to - from) * i / steps)))];
    }

    /// <summary>The paths whose strips come within a distance of a point, at most as far as a cell is wide.</summary>
    public IEnumerable<TownSpot> Near(Vector3D point, double range)
    {
        foreach (TownLane lane in _cells.GetValueOrDefault(CellOf(point)) ?? [])
        {
            if (SpotOn(lane, point) is { } spot && spot.Away <= range)
            {
                yield return spot;
            }
        }
    }

    private static (int X, int Y) CellOf(Vector3D point) => ((int)Math.Floor(point.X / Cell), (int)Math.Floor(point.Y / Cell));

    private static TownSpot? SpotOn(TownLane lane, Vector3D point)
    {
        IReadOnlyList<Vector3D> line = lane.Points;
        (double start, double end) = (lane.StartWidth / 2, lane.EndWidth / 2);
        double least = double.PositiveInfinity;
        double passed = 0;
        TownSpot? best = null;
        for (int i = 0; i + 1 < line.Count; i++)
        {
            (double x, double y) = (line[i + 1].X - line[i].X, line[i + 1].Y - line[i].Y);
            (double px, double py) = (point.X - line[i].X, point.Y - line[i].Y);
            double length = Math.Sqrt((x * x) + (y * y));
            if (length == 0)
            {
                continue;
            }

            double ahead = ((px * x) + (py * y)) / length;
            double right = ((py * -x) + (px * y)) / length;
            double within = Math.Clamp(ahead, 0, length);
            double distance = Math.Sqrt((right * right) + ((ahead - within) * (ahead - within)));
            if (distance < least)
            {
                least = distance;
                bool isEnd = (i == 0 && ahead < 0) || (i == line.Count - 2 && ahead > length);
                double half = start + ((end - start) * (i + (within / length)) / (line.Count - 1));
                double aside = Math.Max(0, (isEnd ? Math.Abs(right) : distance) - half);
                double beyond = isEnd ? Math.Abs(ahead - within) : 0;
                double away = Math.Sqrt((aside * aside) + (beyond * beyond));
                double height = point.Z - line[i].Z - ((line[i + 1].Z - line[i].Z) * within / length);
                best =
                    Math.Abs(height) > Level
                        ? null
                        : new TownSpot(lane, passed + within, right, half, away <= Rounding ? 0 : away, Math.Atan2(y, x));
            }

            passed += length;
        }

        return best;
    }
}
