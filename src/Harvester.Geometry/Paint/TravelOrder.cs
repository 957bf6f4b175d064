using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The drivable links in an order in which one can travel: depth first along the roads, so that the next link nearly always begins where
/// the one before ends.
/// </summary>
internal static class TravelOrder
{
    /// <summary>The links, each once, with whether it is passed from its start to its end.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="isWanted">Whether a link takes part.</param>
    /// <param name="start">Index of the node to start from.</param>
    public static List<(int Link, bool IsForward)> Of(RoadNetwork network, Predicate<int> isWanted, int start)
    {
        var order = new List<(int, bool)>();
        bool[] isDone = new bool[network.Links.Count];
        for (int link = 0; link < isDone.Length; link++)
        {
            isDone[link] = !RoadContinuations.IsDrivable(network, network.Links[link]) || !isWanted(link);
        }

        Travel(network, isDone, start, order);
        for (int link = 0; link < isDone.Length; link++)
        {
            if (!isDone[link])
            {
                Travel(network, isDone, network.Links[link].From, order);
            }
        }

        return order;
    }

    private static void Travel(RoadNetwork network, bool[] isDone, int start, List<(int Link, bool IsForward)> order)
    {
        var nodes = new Stack<int>([start]);
        while (nodes.Count > 0)
        {
            int node = nodes.Peek();
            int next = Next(network, isDone, node);
            if (next < 0)
            {
                nodes.Pop();
                continue;
            }

            isDone[next] = true;
            RoadLink road = network.Links[next];
            order.Add((next, road.From == node));
            nodes.Push(road.From == node ? road.To : road.From);
        }
    }

    private static int Next(RoadNetwork network, bool[] isDone, int node)
    {
        foreach (int link in network.LinksOf(node))
        {
            if (!isDone[link])
            {
                return link;
            }
        }

        return -1;
    }
}
