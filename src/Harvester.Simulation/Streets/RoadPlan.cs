using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Simulation.Streets;

/// <summary>The roads and junctions of a world.</summary>
/// <param name="Roads">In the order of their indices.</param>
/// <param name="Junctions">In the order of their nodes.</param>
internal sealed record RoadPlan(IReadOnlyList<Road> Roads, IReadOnlyList<Junction> Junctions)
{
    private const double MaxTrim = 30;
    private const double CrossingRoom = 3.5;
    private const double LayoutChange = 10;
    private const double InnerRoadLength = 24;

    /// <summary>Plans the part of a network within a radius of a point.</summary>
    /// <param name="network">The network.</param>
    /// <param name="centre">The point, metres.</param>
    /// <param name="radius">Metres.</param>
    /// <param name="settlement">Where town and country are; null for town everywhere.</param>
    /// <param name="varySeed">Seed of lane widths and paint drawn at random; null for those of the network and ordinary roads.</param>
    /// <exception cref="ArgumentException">No road lies there.</exception>
    public static RoadPlan Build(RoadNetwork network, Vector3D centre, double radius, Settlement? settlement = null, int? varySeed = null)
    {
        RoadLink[] links = [.. network.Links.Where(link => IsRoad(network, link, centre, radius))];
        if (links.Length == 0)
        {
            throw new ArgumentException(
                FormattableString.Invariant($"No road lies within {radius} m of {centre.X}, {centre.Y}; choose another place.")
            );
        }

        List<RoadChain> chains = RoadChain.Follow(network, links);
        if (varySeed is { } seed)
        {
            chains = chains.ConvertAll(chain => RandomRoads.Vary(chain, seed));
        }

        Dictionary<(int Node, int Neighbour), Vector3D> tangents = RoadChain.EndTangents(network, chains);
        List<Road> roads =
        [
            .. chains.Select((chain, index) => MakeRoad(network, chain, index, tangents, settlement ?? Settlement.Everywhere)),
        ];
        List<Junction> junctions = FindJunctions(network, roads);
        foreach (Junction junction in junctions)
        {
            Trim(junction);
        }

        HashSet<int> wide = [.. junctions.Where(junction => junction.IsCrossing || junction.IsCorner).Select(junction => junction.Node)];
        foreach (Road road in roads)
        {
            road.IsInner = road.Length < InnerRoadLength && wide.Contains(road.Nodes[0]) && wide.Contains(road.Nodes[^1]);
        }

        return new RoadPlan(roads, junctions);
    }

    private static bool IsRoad(RoadNetwork network, RoadLink link, Vector3D centre, double radius)
    {
        RoadNode from = network.Nodes[link.From];
        RoadNode to = network.Nodes[link.To];
        const RoadLinkFlags unpainted = RoadLinkFlags.Shortcut | RoadLinkFlags.DontUseForNavigation;
        const double shortestLink = 0.5;
        return (link.Flags & unpainted) == 0
            && link.LanesForward + link.LanesBackward > 0
            && ((from.Flags | to.Flags) & RoadNodeFlags.Water) == 0
            && Horizontal.Distance(from.Position, centre) < radius
            && Horizontal.Distance(to.Position, centre) < radius
            && Horizontal.Distance(from.Position, to.Position) > shortestLink;
    }

    private static Road MakeRoad(
        RoadNetwork network,
        RoadChain chain,
        int index,
        Dictionary<(int Node, int Neighbour), Vector3D> tangents,
        Settlement settlement
    )
    {
        IReadOnlyList<int> nodes = chain.Nodes;
        IEnumerable<int> ownNodes = nodes.Count > 2 ? nodes.Skip(1).SkipLast(1) : nodes;
        RoadNodeFlags flags = ownNodes.Aggregate(~RoadNodeFlags.None, (common, node) => common & network.Nodes[node].Flags);
        StreetCurve curve = new(
            [.. nodes.Select(node => network.Nodes[node].Position)],
            tangents.TryGetValue((nodes[0], nodes[1]), out Vector3D start) ? start : null,
            tangents.TryGetValue((nodes[^1], nodes[^2]), out Vector3D end) ? -end : null
        );
        return new Road(index, nodes, chain.Layout, flags, curve) { Zone = settlement.At(curve.PositionAt(curve.Length / 2)) };
    }

    private static List<Junction> FindJunctions(RoadNetwork network, List<Road> roads)
    {
        SortedDictionary<int, List<RoadArm>> arms = [];
        foreach (Road road in roads)
        {
            Add(road.Nodes[0], new RoadArm(road, AtStart: true));
            Add(road.Nodes[^1], new RoadArm(road, AtStart: false));
        }

        return
        [
            .. arms.Select(pair => new Junction(pair.Key, network.Nodes[pair.Key].Position, network.Nodes[pair.Key].Flags, pair.Value)),
        ];

        void Add(int node, RoadArm arm)
        {
            if (!arms.TryGetValue(node, out List<RoadArm>? list))
            {
                arms[node] = list = [];
            }

            list.Add(arm);
        }
    }

    private static void Trim(Junction junction)
    {
        foreach (RoadArm arm in junction.Arms)
        {
            double trim = junction.Arms.Count switch
            {
                1 => 0,
                2 when !junction.IsCorner => LayoutChange,
                _ => junction.Arms.Where(other => other != arm).Max(other => SetBack(arm, other)) + CrossingRoom,
            };
            arm.Road.SetTrim(arm.AtStart, trim);
            arm.Road.StartsAtCrossing |= arm.AtStart && (junction.IsCrossing || junction.IsCorner);
            arm.Road.EndsAtCrossing |= !arm.AtStart && (junction.IsCrossing || junction.IsCorner);
        }
    }

    /// <summary>
    /// Distance from the node at which an arm's edge leaves the carriageway of another: (b + a·cos t) / sin t for half widths a and b.
    /// </summary>
    private static double SetBack(RoadArm arm, RoadArm other)
    {
        double angle = Math.Abs(Horizontal.Turn(arm.Outward, other.Outward));
        const double nearlyStraightOn = 2.6;
        const double nearlyParallel = 0.05;
        double half = arm.Road.Layout.HalfWidth + arm.Road.Shoulder;
        double otherHalf = other.Road.Layout.HalfWidth + other.Road.Shoulder;
        return angle > nearlyStraightOn ? 0
            : angle < nearlyParallel ? MaxTrim
            : Math.Clamp((otherHalf + (half * Math.Cos(angle))) / Math.Sin(angle), 0, MaxTrim);
    }
}
