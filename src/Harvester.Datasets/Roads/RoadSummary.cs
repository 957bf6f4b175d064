using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>Counts and lengths of a road network.</summary>
public static class RoadSummary
{
    /// <summary>Names and values in a fixed order; flags that no node or link has are omitted.</summary>
    public static IReadOnlyList<(string Name, string Value)> Of(RoadNetwork network)
    {
        ArgumentNullException.ThrowIfNull(network);
        var curves = new RoadCurves(network);
        var lanes = new LaneModel(network);
        double metres = Enumerable.Range(0, network.Links.Count).Sum(link => curves.Of(link).Length);
        var rows = new List<(string, string)>
        {
            ("nodes", Text(network.Nodes.Count)),
            ("links", Text(network.Links.Count)),
            ("length", FormattableString.Invariant($"{metres / 1000:0.0} km")),
            ("cells with nodes", Text(network.Nodes.Select(node => node.Area).Where(area => area != RoadNode.NoArea).Distinct().Count())),
            ("nodes with a street name", Text(network.Nodes.Count(node => node.Street.Length > 0))),
            ("drivable links", Text(network.Links.Count(link => RoadContinuations.IsDrivable(network, link)))),
            ("one-way links", Text(network.Links.Count(link => link.IsOneWay))),
            ("links with a known median", Text(network.Links.Count(link => link.MedianWidth is not null))),
            (
                "links with calibrated lanes",
                Text(
                    Enumerable
                        .Range(0, network.Links.Count)
                        .Count(link => lanes.WidthOf(link, isForward: true, station: 0).Source == LaneWidthSource.Calibrated)
                )
            ),
        };
        rows.AddRange(Counts<RoadNodeFlags>("node", flag => network.Nodes.Count(node => node.Flags.HasFlag(flag))));
        rows.AddRange(Counts<RoadLinkFlags>("link", flag => network.Links.Count(link => link.Flags.HasFlag(flag))));
        rows.AddRange(
            network
                .Links.GroupBy(link =>
                    (Max: Math.Max(link.LanesForward, link.LanesBackward), Min: Math.Min(link.LanesForward, link.LanesBackward))
                )
                .OrderBy(lanes => lanes.Key)
                .Select(lanes => (FormattableString.Invariant($"links with {lanes.Key.Max} + {lanes.Key.Min} lanes"), Text(lanes.Count())))
        );
        return rows;
    }

    private static IEnumerable<(string, string)> Counts<T>(string kind, Func<T, int> count)
        where T : struct, Enum =>
        Enum.GetValues<T>()
            .Where(flag => Convert.ToInt32(flag, null) != 0)
            .Select(flag => (Name: $"{kind} flag {flag}", Count: count(flag)))
            .Where(row => row.Count > 0)
            .Select(row => (row.Name, Text(row.Count)));

    private static string Text(int count) => FormattableString.Invariant($"{count}");
}
