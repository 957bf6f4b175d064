namespace Harvester.Geometry.Roads;

/// <summary>The part of a road network around a place, as a network of its own.</summary>
public static class RoadsAround
{
    /// <summary>Cuts a network.</summary>
    /// <param name="network">The network.</param>
    /// <param name="area">Part of the world, metres. Links with a node in it are kept, whole; what they touch outside ends there.</param>
    /// <returns>The kept nodes and links in their order, with numbers of their own.</returns>
    public static RoadNetwork Of(RoadNetwork network, Box2D area)
    {
        Guard.NotNull(network, nameof(network));
        int[] links =
        [
            .. Enumerable
                .Range(0, network.Nodes.Count)
                .Where(node => Contains(area, network.Nodes[node].Position))
                .SelectMany(network.LinksOf)
                .Distinct()
                .OrderBy(static link => link),
        ];
        int[] nodes =
        [
            .. links.SelectMany(link => (int[])[network.Links[link].From, network.Links[link].To]).Distinct().OrderBy(static node => node),
        ];
        Dictionary<int, int> numbers = Numbers(nodes);
        Dictionary<int, int> linkNumbers = network.Edges.Count == 0 ? [] : Numbers(links);
        return new RoadNetwork(
            [.. nodes.Select(node => network.Nodes[node])],
            [
                .. links.Select(link =>
                    network.Links[link] with
                    {
                        From = numbers[network.Links[link].From],
                        To = numbers[network.Links[link].To],
                    }
                ),
            ],
            [.. network.Edges.Where(edge => linkNumbers.ContainsKey(edge.Link)).Select(edge => edge with { Link = linkNumbers[edge.Link] })]
        );
    }

    private static Dictionary<int, int> Numbers(int[] kept) =>
        Enumerable.Range(0, kept.Length).ToDictionary(index => kept[index], index => index);

    private static bool Contains(Box2D area, Vector3D place) =>
        place.X >= area.XMin && place.X <= area.XMax && place.Y >= area.YMin && place.Y <= area.YMax;
}
