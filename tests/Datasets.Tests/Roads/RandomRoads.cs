using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Networks in which every flag, speed, density, lane count and median occurs, from a seed.</summary>
internal static class RandomRoads
{
    /// <summary>The flags that are a node's kind: it has one of them at most.</summary>
    private static readonly RoadNodeFlags[] Kinds =
    [
        RoadNodeFlags.None,
        RoadNodeFlags.Parking,
        RoadNodeFlags.PedestrianCrossing,
        RoadNodeFlags.PedestrianAssisted,
        RoadNodeFlags.TrafficLight,
        RoadNodeFlags.GiveWay,
        RoadNodeFlags.Caution,
        RoadNodeFlags.PedestrianCrossingWithoutWait,
        RoadNodeFlags.EmergencyOnly,
        RoadNodeFlags.OffRoadJunction,
    ];

    private static readonly RoadNodeFlags AllKinds = Kinds.Aggregate((sum, flag) => sum | flag);

    /// <summary>The flags of nodes that only the cells of the game have, not the older text files.</summary>
    public const RoadNodeFlags OfCellsOnly = RoadNodeFlags.Junction | RoadNodeFlags.DeadEnd;

    /// <summary>
    /// Makes a network whose positions lie where the de-biased ones of truncated files do, so that every format can hold it.
    /// </summary>
    public static RoadNetwork Make(int seed, int nodeCount, int linkCount)
    {
        var random = new Random(seed);
        RoadNode[] nodes = [.. Enumerable.Range(0, nodeCount).Select(i => Node(random, i))];
        var links = new Dictionary<(int, int), RoadLink>();
        while (links.Count < linkCount)
        {
            int from = random.Next(nodeCount);
            int to = random.Next(nodeCount);
            if (from != to)
            {
                links.TryAdd(
                    (Math.Min(from, to), Math.Max(from, to)),
                    new RoadLink(
                        from,
                        to,
                        random.Next(8),
                        random.Next(8),
                        random.Next(4) == 0 ? null : random.Next(15),
                        (RoadLinkFlags)random.Next(32)
                    )
                );
            }
        }

        return new RoadNetwork(nodes, [.. links.Values]);
    }

    /// <summary>The network with reported points on the edges of some of its links.</summary>
    public static RoadNetwork WithEdges(RoadNetwork network, int seed)
    {
        var random = new Random(seed);
        IEnumerable<RoadEdge> edges = Enumerable
            .Range(0, network.Links.Count)
            .Where(_ => random.Next(2) == 0)
            .Select(link =>
            {
                bool isAtStart = random.Next(2) == 0;
                RoadNode node = network.Nodes[isAtStart ? network.Links[link].From : network.Links[link].To];
                return new RoadEdge(
                    link,
                    isAtStart,
                    PathGrid.RemoveBias(PathGrid.Truncate(node.Position + new Vector3D(random.Next(20), random.Next(20), 0)))
                );
            });
        return new RoadNetwork(network.Nodes, network.Links, [.. edges]);
    }

    private static RoadNode Node(Random random, int index)
    {
        Vector3D stored = PathGrid.Truncate(
            new Vector3D((random.NextDouble() * 8000) - 4000, (random.NextDouble() * 8000) - 4000, (random.NextDouble() * 500) - 50)
        );
        Vector3D position = PathGrid.RemoveBias(stored);
        RoadNodeFlags flags = ((RoadNodeFlags)random.Next(1 << 24) & ~AllKinds) | Kinds[random.Next(Kinds.Length)];
        string street = random.Next(2) == 0 ? "" : "hash_" + random.Next(1, int.MaxValue).ToString("X8", null);
        return new RoadNode(PathGrid.CellOf(stored), index, position, street, flags)
        {
            Speed = (RoadSpeed)random.Next(4),
            Density = random.Next(16),
        };
    }
}
