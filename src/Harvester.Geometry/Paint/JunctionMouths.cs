using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Paint;

/// <summary>
/// The mouths of all roads at the junctions of a network: where stop lines, pedestrian crossings and arrows are looked for. A road between
/// two junctions is divided in its middle.
/// </summary>
internal sealed class JunctionMouths
{
    /// <summary>
    /// Length of a mouth beyond the extent of its junction, metres. That is computed with the constant lane width; three lanes of the other
    /// road may be 3 m wider, and beyond its edge follow a shoulder, a crossing, the stop line, and arrows up to 8 m behind it.
    /// </summary>
    private const double BeyondExtent = 18;

    private readonly Lazy<IReadOnlyList<JunctionMouth>> _all;

    public JunctionMouths(PaintRoads roads) => _all = new(() => Find(roads));

    /// <summary>The mouths, by node and then link.</summary>
    public IReadOnlyList<JunctionMouth> All => _all.Value;

    private static List<JunctionMouth> Find(PaintRoads roads)
    {
        RoadNetwork network = roads.Curves.Network;
        var mouths = new List<JunctionMouth>();
        for (int node = 0; node < network.Nodes.Count; node++)
        {
            if (!JunctionExtents.IsJunction(network, node))
            {
                continue;
            }

            foreach (int link in network.LinksOf(node))
            {
                if (RoadContinuations.IsDrivable(network, network.Links[link]))
                {
                    mouths.Add(Of(roads, node, link));
                }
            }
        }

        return mouths;
    }

    private static JunctionMouth Of(PaintRoads roads, int node, int first)
    {
        RoadNetwork network = roads.Curves.Network;
        (double fromStart, double fromEnd) = roads.Junctions.Of(first);
        double wanted = BeyondExtent + (network.Links[first].From == node ? fromStart : fromEnd);
        var links = new List<(int, bool, double)>();
        double length = 0;
        int link = first;
        while (true)
        {
            bool isForward = network.Links[link].From == node;
            links.Add((link, isForward, length));
            length += roads.Curves.Of(link).Length;
            node = isForward ? network.Links[link].To : network.Links[link].From;
            if (JunctionExtents.IsJunction(network, node))
            {
                return new JunctionMouth(roads, links, Math.Min(wanted, length / 2));
            }

            // Beyond twice the wanted length, a further junction changes nothing.
            link = roads.Curves.Continuations.Of(link, beyondEnd: isForward);
            if (link == RoadContinuations.None || length >= 2 * wanted)
            {
                return new JunctionMouth(roads, links, Math.Min(wanted, length));
            }
        }
    }
}
