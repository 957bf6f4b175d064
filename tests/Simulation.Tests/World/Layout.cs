using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Tests.World;

/// <summary>Draws road networks that are difficult to build: roads that cross, climb and join at different heights.</summary>
internal sealed class Layout
{
    private const double NodeSpacing = 10;

    private readonly List<RoadNode> _nodes = [];
    private readonly List<RoadLink> _links = [];

    public static IEnumerable<string> Names => ["crossing", "ramp", "hill", "serpentine", "interchange", "parallel", "tunnel"];

    public static RoadNetwork Named(string name)
    {
        Layout layout = new();
        switch (name)
        {
            case "crossing":
                layout.Add(2, 2, RoadNodeFlags.None, new(-300, 0, 30), new(300, 0, 30));
                layout.Add(1, 1, RoadNodeFlags.None, new(0, -300, 31), new(0, -80, 37), new(0, 80, 37), new(0, 300, 31));
                break;
            case "ramp":
                // A street from the lower road up to the bridge over it.
                layout.Add(1, 1, RoadNodeFlags.None, new(-300, 0, 30), new(-120, 0, 30));
                layout.Add(1, 1, RoadNodeFlags.None, new(-120, 0, 30), new(300, 0, 30));
                layout.Add(1, 1, RoadNodeFlags.None, new(0, -300, 31), new(0, -120, 38));
                layout.Add(1, 1, RoadNodeFlags.None, new(0, -120, 38), new(0, 60, 38), new(0, 300, 31));
                layout.Add(1, 1, RoadNodeFlags.None, new(-120, 0, 30), new(-90, -60, 32.5), new(-40, -105, 37), new(0, -120, 38));
                break;
            case "hill":
                // A street of 15 % with side streets along the slope.
                foreach (double y in new[] { -200.0, -100, 0, 100 })
                {
                    layout.Add(1, 1, RoadNodeFlags.None, new(0, y, 60 + (0.15 * y)), new(0, y + 100, 75 + (0.15 * y)));
                    layout.Add(1, 1, RoadNodeFlags.None, new(0, y, 60 + (0.15 * y)), new(150, y, 62 + (0.15 * y)));
                    layout.Add(1, 1, RoadNodeFlags.None, new(-150, y, 58 + (0.15 * y)), new(0, y, 60 + (0.15 * y)));
                }

                break;
            case "serpentine":
                // Three legs of 8 % with two hairpins of 25 m radius.
                layout.Add(
                    1,
                    1,
                    RoadNodeFlags.None,
                    [
                        new(-200, 0, 50),
                        new(60, 0, 70.8),
                        .. Bend(60, 25, 70.8, 1),
                        new(-60, 50, 86.7),
                        .. Bend(-60, 75, 86.7, -1),
                        new(200, 100, 113.8),
                    ]
                );
                break;
            case "interchange":
                layout.Add(2, 0, RoadNodeFlags.Highway, new(-400, -8, 20), new(-150, -8, 20));
                layout.Add(2, 0, RoadNodeFlags.Highway, new(-150, -8, 20), new(400, -8, 20));
                layout.Add(2, 0, RoadNodeFlags.Highway, new(400, 8, 20), new(-400, 8, 20));
                layout.Add(1, 1, RoadNodeFlags.None, new(0, -300, 22), new(0, -120, 27.5));
                layout.Add(1, 1, RoadNodeFlags.None, new(0, -120, 27.5), new(0, 120, 27.5), new(0, 300, 22));
                layout.Add(
                    1,
                    0,
                    RoadNodeFlags.Highway,
                    new(-150, -8, 20),
                    new(-110, -14, 20),
                    new(-60, -40, 22),
                    new(-20, -90, 26),
                    new(0, -120, 27.5)
                );
                break;
            case "parallel":
                // Two carriageways that drift apart in height.
                layout.Add(2, 0, RoadNodeFlags.Highway, new(-300, -7, 40), new(0, -7, 40.6), new(300, -9, 44));
                layout.Add(2, 0, RoadNodeFlags.Highway, new(300, 8, 40), new(0, 7, 40), new(-300, 7, 40));
                break;
            case "tunnel":
                // Two carriageways through a hill, each with a tunnel of 200 m.
                layout.Add(2, 0, RoadNodeFlags.Highway, new(-300, -9, 40), new(-110, -9, 40));
                layout.Add(2, 0, RoadNodeFlags.Highway | RoadNodeFlags.Tunnel, new(-100, -9, 40), new(100, -9, 41));
                layout.Add(2, 0, RoadNodeFlags.Highway, new(110, -9, 41), new(300, -9, 41));
                layout.Add(2, 0, RoadNodeFlags.Highway, new(-110, -9, 40), new(-100, -9, 40));
                layout.Add(2, 0, RoadNodeFlags.Highway, new(100, -9, 41), new(110, -9, 41));
                layout.Add(1, 1, RoadNodeFlags.None, new(-300, 60, 40), new(-110, 60, 40));
                layout.Add(1, 1, RoadNodeFlags.Tunnel, new(-100, 60, 40), new(0, 60, 40), new(80, 100, 42));
                layout.Add(1, 1, RoadNodeFlags.None, new(-110, 60, 40), new(-100, 60, 40));
                layout.Add(1, 1, RoadNodeFlags.None, new(80, 100, 42), new(250, 180, 42));
                break;
            default:
                throw new ArgumentException($"There is no layout '{name}'.", nameof(name));
        }

        return new RoadNetwork(layout._nodes, layout._links);
    }

    /// <summary>Points of a half circle of 25 m that rises by 6.3 m, to the east or the west of its centre.</summary>
    private static IEnumerable<Vector3D> Bend(double x, double y, double z, int side) =>
        Enumerable
            .Range(1, 12)
            .Select(i =>
            {
                const double radius = 25;
                (double sin, double cos) = Math.SinCos(Math.PI * i / 12);
                return new Vector3D(x + (side * radius * sin), y - (radius * cos), z + (6.3 * i / 12));
            });

    /// <summary>Adds a road along straight pieces; ends that coincide with those of other roads are joined.</summary>
    private void Add(int forward, int backward, RoadNodeFlags flags, params Vector3D[] corners)
    {
        int previous = NodeAt(corners[0], flags);
        for (int i = 1; i < corners.Length; i++)
        {
            Vector3D way = corners[i] - corners[i - 1];
            int steps = (int)Math.Ceiling(way.Length / NodeSpacing);
            for (int step = 1; step <= steps; step++)
            {
                int node = NodeAt(corners[i - 1] + (way * ((double)step / steps)), flags);
                _links.Add(new RoadLink(previous, node, forward, backward, 0, RoadLinkFlags.None));
                previous = node;
            }
        }
    }

    private int NodeAt(Vector3D place, RoadNodeFlags flags)
    {
        int known = _nodes.FindIndex(node => (node.Position - place).Length < 0.01);
        if (known < 0)
        {
            _nodes.Add(new RoadNode(0, _nodes.Count, place, "", flags));
        }

        return known < 0 ? _nodes.Count - 1 : known;
    }
}
