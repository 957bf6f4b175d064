using Harvester.Geometry;
using Harvester.Simulation.Streets;
using Harvester.Simulation.World;

namespace Harvester.Simulation.Tests.Events;

/// <summary>The paths on which the town's own traffic drives, as strips of their lanes' width: the nearest points by brute force.</summary>
internal sealed class TownLanes
{
    private const double Cell = 20;
    private const double Level = 3;
    private const double Rounding = 1e-6;

    private readonly Dictionary<(int X, int Y), List<LanePath>> _cells = [];

    public TownLanes(Site site)
    {
        foreach (LanePath path in site.Lanes.Paths)
        {
            foreach ((int x, int y) in path.Line.Points.Select(CellOf).Distinct())
            {
                for (int i = -1; i <= 1; i++)
                {
                    for (int j = -1; j <= 1; j++)
                    {
                        if (!_cells.TryGetValue((x + i, y + j), out List<LanePath>? paths))
                        {
                            _cells.Add((x + i, y + j), paths = []);
                        }

                        if (!paths.Contains(path))
                        {
                            paths.Add(path);
                        }
                    }
                }
            }
        }
    }

    /// <summary>The paths whose strips come within a distance of a point, at most as far as a cell is wide.</summary>
    public IEnumerable<TownSpot> Near(Vector3D point, double range)
    {
        foreach (LanePath path in _cells.GetValueOrDefault(CellOf(point)) ?? [])
        {
            if (SpotOn(path, point) is { } spot && spot.Away <= range)
            {
                yield return spot;
            }
        }
    }

    private static (int X, int Y) CellOf(Vector3D point) => ((int)Math.Floor(point.X / Cell), (int)Math.Floor(point.Y / Cell));

    private static TownSpot? SpotOn(LanePath path, Vector3D point)
    {
        IReadOnlyList<Vector3D> line = path.Line.Points;
        (double start, double end) = (
            (path.Road ?? path.Previous[0].Road!).Layout.LaneWidth / 2,
            (path.Road ?? path.Next[0].Road!).Layout.LaneWidth / 2
        );
        double least = double.PositiveInfinity;
        double passed = 0;
        TownSpot? best = null;
        for (int i = 0; i + 1 < line.Count; i++)
        {
            (double x, double y) = (line[i + 1].X - line[i].X, line[i + 1].Y - line[i].Y);
            (double px, double py) = (point.X - line[i].X, point.Y - line[i].Y);
            double length = Math.Sqrt((x * x) + (y * y));
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
                        : new TownSpot(path, passed + within, right, half, away <= Rounding ? 0 : away, Math.Atan2(y, x));
            }

            passed += length;
        }

        return best;
    }
}
