using System.Text.Json;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Writes the JSON dump of nodes.</summary>
internal static class DumpText
{
    /// <summary>The flags that the dump can hold as they are.</summary>
    public const RoadNodeFlags Flags =
        RoadNodeFlags.NoGps
        | RoadNodeFlags.Junction
        | RoadNodeFlags.Highway
        | RoadNodeFlags.OffRoad
        | RoadNodeFlags.SwitchedOff
        | RoadNodeFlags.Water
        | RoadNodeFlags.PedestrianCrossing
        | RoadNodeFlags.TrafficLight
        | RoadNodeFlags.IndicateKeepLeft
        | RoadNodeFlags.IndicateKeepRight;

    private static readonly JsonSerializerOptions Indented = new() { WriteIndented = true };

    public static string Of(RoadNetwork network) =>
        JsonSerializer.Serialize(
            network
                .Nodes.Select((node, index) => (node, index))
                .GroupBy(item => item.node.Area)
                .Select(area => new
                {
                    AreaId = area.Key,
                    Nodes = area.Select(item =>
                        Node(item.node, network.LinksOf(item.index).Select(i => Connection(network, item.index, network.Links[i])))
                    ),
                }),
            Indented
        );

    private static object Connection(RoadNetwork network, int from, RoadLink link)
    {
        RoadLink seen = link.From == from ? link : link.Reversed();
        return new
        {
            Node = Node(network.Nodes[seen.To], null),
            LaneCountForward = seen.LanesForward,
            LaneCountBackward = seen.LanesBackward,
        };
    }

    private static object Node(RoadNode node, IEnumerable<object>? connections)
    {
        var stored = PathGrid.Truncate(node.Position);
        return new
        {
            Id = node.Number,
            StreetName = node.Street.Length == 0 ? "0" : node.Street,
            IsValidForGps = !node.Flags.HasFlag(RoadNodeFlags.NoGps),
            IsJunction = node.Flags.HasFlag(RoadNodeFlags.Junction),
            IsFreeway = node.Flags.HasFlag(RoadNodeFlags.Highway),
            IsGravelRoad = node.Flags.HasFlag(RoadNodeFlags.OffRoad),
            IsBackroad = node.Flags.HasFlag(RoadNodeFlags.SwitchedOff),
            IsOnWater = node.Flags.HasFlag(RoadNodeFlags.Water),
            IsPedCrossway = node.Flags.HasFlag(RoadNodeFlags.PedestrianCrossing),
            TrafficlightExists = node.Flags.HasFlag(RoadNodeFlags.TrafficLight),
            LeftTurnNoReturn = node.Flags.HasFlag(RoadNodeFlags.IndicateKeepLeft),
            RightTurnNoReturn = node.Flags.HasFlag(RoadNodeFlags.IndicateKeepRight),
            Position = new
            {
                stored.X,
                stored.Y,
                stored.Z,
            },
            ConnectedNodes = connections,
        };
    }
}
