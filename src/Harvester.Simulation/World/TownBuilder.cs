using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.World;

/// <summary>
/// Generates a town: a grid of streets and avenues with bends, one-way streets and an avenue with a median, a motorway around it, and a
/// winding country road over the hills outside. The same seed gives the same town.
/// </summary>
public sealed class TownBuilder
{
    private const int GridSize = 5;
    private const double BlockLength = 125;
    private const double Jitter = 9;
    private const double MotorwayDistance = 430;
    private const double MotorwayRadius = 160;
    private const int Middle = GridSize / 2;

    private readonly Random _random;
    private readonly double _eastPhase;
    private readonly double _northPhase;
    private readonly List<RoadNode> _nodes = [];
    private readonly List<RoadLink> _links = [];

    private TownBuilder(int seed)
    {
        _random = new Random(seed);
        _eastPhase = _random.NextDouble() * 2 * Math.PI;
        _northPhase = _random.NextDouble() * 2 * Math.PI;
    }

    /// <summary>The road network of a town; its centre is at the origin.</summary>
    public static RoadNetwork Build(int seed)
    {
        TownBuilder builder = new(seed);
        int[,] grid = builder.AddCrossings();
        builder.AddStreets(grid);
        builder.AddMotorway(grid);
        return new RoadNetwork(builder._nodes, builder._links);
    }

    private int[,] AddCrossings()
    {
        int[,] grid = new int[GridSize, GridSize];
        for (int column = 0; column < GridSize; column++)
        {
            for (int row = 0; row < GridSize; row++)
            {
                Vector3D place = new(
                    ((column - Middle) * BlockLength) + (Jitter * ((2 * _random.NextDouble()) - 1)),
                    ((row - Middle) * BlockLength) + (Jitter * ((2 * _random.NextDouble()) - 1)),
                    0
                );
                grid[column, row] = IsCorner(column, row) ? -1 : AddNode(place, RoadNodeFlags.Junction);
            }
        }

        return grid;
    }

    private static bool IsCorner(int column, int row) => column % (GridSize - 1) == 0 && row % (GridSize - 1) == 0;

    private void AddStreets(int[,] grid)
    {
        for (int line = 0; line < GridSize; line++)
        {
            for (int i = 0; i < GridSize - 1; i++)
            {
                if (!IsCorner(line, i) && !IsCorner(line, i + 1))
                {
                    AddStreet(grid[line, i], grid[line, i + 1], LanesNorthward(line));
                }

                if (!IsCorner(i, line) && !IsCorner(i + 1, line))
                {
                    AddStreet(grid[i, line], grid[i + 1, line], LanesEastward(line));
                }
            }
        }

        foreach (int column in new[] { 0, GridSize - 1 })
        {
            foreach (int row in new[] { 0, GridSize - 1 })
            {
                int inRow = grid[column == 0 ? 1 : column - 1, row];
                int inColumn = grid[column, row == 0 ? 1 : row - 1];
                Vector3D corner = new((column - Middle) * BlockLength, (row - Middle) * BlockLength, 0);
                const double cornerRadius = 40;
                AddRoad(inRow, inColumn, [corner], cornerRadius, new RoadLanes(1, 1), RoadNodeFlags.None);
            }
        }
    }

    private static RoadLanes LanesNorthward(int column) =>
        column switch
        {
            1 => new RoadLanes(2, 2, MedianWidth: 4),
            Middle => new RoadLanes(2, 2),
            3 => new RoadLanes(1, 1, IsNarrow: true),
            _ => new RoadLanes(1, 1),
        };

    private static RoadLanes LanesEastward(int row) =>
        row switch
        {
            1 => new RoadLanes(2, 0),
            Middle => new RoadLanes(2, 2),
            3 => new RoadLanes(0, 2),
            _ => new RoadLanes(1, 1),
        };

    private void AddStreet(int from, int to, RoadLanes lanes)
    {
        const double bendRadius = 45;
        const double maxBend = 14;
        bool bends = _random.Next(3) == 0;
        double bend = maxBend * ((2 * _random.NextDouble()) - 1);
        Vector3D start = Level(from);
        Vector3D way = Level(to) - start;
        Vector3D aside = Horizontal.RightOf(way) * bend;
        Vector3D[] corners = bends
            ? [start + (way * 0.25), start + (way * 0.42) + aside, start + (way * 0.58) + aside, start + (way * 0.75)]
            : [];
        AddRoad(from, to, corners, bendRadius, lanes, RoadNodeFlags.None);
    }

    private void AddMotorway(int[,] grid)
    {
        const double d = MotorwayDistance;
        int north = AddNode(new Vector3D(0, d, 0), RoadNodeFlags.Junction | RoadNodeFlags.Highway);
        int east = AddNode(new Vector3D(d, 0, 0), RoadNodeFlags.Junction | RoadNodeFlags.Highway);
        int south = AddNode(new Vector3D(0, -d, 0), RoadNodeFlags.Junction | RoadNodeFlags.Highway);
        int west = AddNode(new Vector3D(-d, 0, 0), RoadNodeFlags.Junction | RoadNodeFlags.Highway);
        RoadLanes motorway = new(2, 2, MedianWidth: 8);
        AddRoad(north, east, [new Vector3D(d, d, 0)], MotorwayRadius, motorway, RoadNodeFlags.Highway);
        AddRoad(east, south, [new Vector3D(d, -d, 0)], MotorwayRadius, motorway, RoadNodeFlags.Highway);
        AddRoad(south, west, [new Vector3D(-d, -d, 0)], MotorwayRadius, motorway, RoadNodeFlags.Highway);
        AddRoad(west, north, [new Vector3D(-d, d, 0)], MotorwayRadius, motorway, RoadNodeFlags.Highway);
        RoadLanes avenue = new(2, 2);
        const int last = GridSize - 1;
        AddRoad(grid[Middle, last], north, [], MotorwayRadius, avenue, RoadNodeFlags.None);
        AddRoad(grid[Middle, 0], south, [], MotorwayRadius, avenue, RoadNodeFlags.None);
        AddRoad(grid[last, Middle], east, [], MotorwayRadius, avenue, RoadNodeFlags.None);
        AddRoad(grid[0, Middle], west, [], MotorwayRadius, avenue, RoadNodeFlags.None);
        Vector3D[] winding =
        [
            new(-d - 140, 20, 0),
            new(-d - 190, -130, 0),
            new(-d - 60, -220, 0),
            new(-d - 170, -350, 0),
            new(-d - 40, -d - 120, 0),
            new(-160, -d - 70, 0),
            new(-90, -d - 180, 0),
            new(20, -d - 130, 0),
        ];
        const double bendRadius = 50;
        AddRoad(west, south, winding, bendRadius, new RoadLanes(1, 1), RoadNodeFlags.None);
    }

    private void AddRoad(int from, int to, IReadOnlyList<Vector3D> corners, double radius, RoadLanes lanes, RoadNodeFlags flags)
    {
        List<Vector3D> way = RoundedWay.Sample([Level(from), .. corners, Level(to)], radius);
        bool hasLights = lanes.Forward + lanes.Backward > 2;
        int previous = from;
        for (int i = 1; i < way.Count; i++)
        {
            bool atStopLine = hasLights && (i is 2 || i == way.Count - 3);
            int node = i == way.Count - 1 ? to : AddNode(way[i], atStopLine ? flags | RoadNodeFlags.TrafficLight : flags);
            RoadLinkFlags linkFlags = lanes.IsNarrow ? RoadLinkFlags.NarrowRoad : RoadLinkFlags.None;
            _links.Add(new RoadLink(previous, node, lanes.Forward, lanes.Backward, lanes.MedianWidth, linkFlags));
            previous = node;
        }
    }

    private Vector3D Level(int node)
    {
        Vector3D position = _nodes[node].Position;
        return new Vector3D(position.X, position.Y, 0);
    }

    private int AddNode(Vector3D place, RoadNodeFlags flags)
    {
        _nodes.Add(new RoadNode(0, _nodes.Count, new Vector3D(place.X, place.Y, Height(place)), string.Empty, flags));
        return _nodes.Count - 1;
    }

    /// <summary>Gentle waves under the town that grow into hills outside it.</summary>
    private double Height(Vector3D place)
    {
        double fromMiddle = Math.Sqrt((place.X * place.X) + (place.Y * place.Y));
        double rise = 1 + (2 * Math.Clamp((fromMiddle - MotorwayDistance) / 200, 0, 1));
        return 30 + (rise * ((3.5 * Math.Sin((place.X / 130) + _eastPhase)) + (3 * Math.Sin((place.Y / 110) + _northPhase))));
    }
}
