using System.Globalization;
using System.Text;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Tests.Roads;

/// <summary>Writes cells of path nodes as CodeWalker does, with the bits set here by hand.</summary>
internal static class YndText
{
    public static IEnumerable<(int Area, string Text)> Cells(RoadNetwork network) =>
        network.Nodes.Select(node => node.Area).Distinct().Order().Select(area => (area, Cell(network, area)));

    private static string Cell(RoadNetwork network, int area)
    {
        int[] indices = [.. Enumerable.Range(0, network.Nodes.Count).Where(i => network.Nodes[i].Area == area)];
        var text = new StringBuilder();
        text.Append("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<NodeDictionary>\n");
        text.Append(
            CultureInfo.InvariantCulture,
            $" <VehicleNodeCount value=\"{indices.Length}\" />\n <PedNodeCount value=\"0\" />\n <Nodes>\n"
        );
        foreach (int index in indices)
        {
            RoadNode node = network.Nodes[index];
            text.Append(
                CultureInfo.InvariantCulture,
                $"  <Item>\n   <AreaID value=\"{node.Area}\" />\n   <NodeID value=\"{node.Number}\" />\n   "
                    + $"<StreetName>{node.Street}</StreetName>\n"
            );
            // A stored coordinate is the unbiased one, truncated again.
            var stored = PathGrid.Truncate(node.Position);
            text.Append(CultureInfo.InvariantCulture, $"   <Position x=\"{stored.X}\" y=\"{stored.Y}\" z=\"{stored.Z}\" />\n");
            int[] flags = NodeBytes(node);
            for (int i = 0; i < 6; i++)
            {
                text.Append(CultureInfo.InvariantCulture, $"   <Flags{i} value=\"{flags[i]}\" />\n");
            }

            text.Append("   <Links>\n");
            foreach (int linkIndex in network.LinksOf(index))
            {
                RoadLink link = network.Links[linkIndex].From == index ? network.Links[linkIndex] : network.Links[linkIndex].Reversed();
                RoadNode to = network.Nodes[link.To];
                int bits = LinkBits(link);
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"    <Item>\n     <ToAreaID value=\"{to.Area}\" />\n     <ToNodeID value=\"{to.Number}\" />\n"
                );
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"     <Flags0 value=\"{bits & 255}\" />\n     <Flags1 value=\"{(bits >> 8) & 255}\" />\n     <Flags2 "
                        + $"value=\"{(bits >> 16) & 255}\" />\n     <LinkLength value=\"8\" />\n    </Item>\n"
                );
            }

            text.Append("   </Links>\n  </Item>\n");
        }

        return text.Append(" </Nodes>\n</NodeDictionary>\n").ToString();
    }

    private static int[] NodeBytes(RoadNode node)
    {
        bool Has(RoadNodeFlags flag) => (node.Flags & flag) != 0;
        return
        [
            (Has(RoadNodeFlags.OffRoad) ? 0x08 : 0)
                + (Has(RoadNodeFlags.NoBigVehicles) ? 0x20 : 0)
                + (Has(RoadNodeFlags.CannotGoRight) ? 0x40 : 0)
                + (Has(RoadNodeFlags.CannotGoLeft) ? 0x80 : 0),
            (Has(RoadNodeFlags.SlipLane) ? 0x01 : 0)
                + (Has(RoadNodeFlags.IndicateKeepLeft) ? 0x02 : 0)
                + (Has(RoadNodeFlags.IndicateKeepRight) ? 0x04 : 0)
                + (IplText.Special(node.Flags) * 8),
            (Has(RoadNodeFlags.NoGps) ? 0x01 : 0)
                + (Has(RoadNodeFlags.Junction) ? 0x04 : 0)
                + (Has(RoadNodeFlags.Water) ? 0x20 : 0)
                + (Has(RoadNodeFlags.Highway) ? 0x40 : 0)
                + (Has(RoadNodeFlags.SwitchedOff) ? 0x80 : 0),
            Has(RoadNodeFlags.Tunnel) ? 0x01 : 0,
            (node.Density ?? 0) + (Has(RoadNodeFlags.DeadEnd) ? 0x30 : 0) + (Has(RoadNodeFlags.LeftTurnsOnly) ? 0x80 : 0),
            (int)(node.Speed ?? 0) * 2,
        ];
    }

    private static int LinkBits(RoadLink link)
    {
        bool Has(RoadLinkFlags flag) => (link.Flags & flag) != 0;
        return (Has(RoadLinkFlags.GpsBothWays) ? 0x1 : 0)
            + (Has(RoadLinkFlags.BlockIfNoLanes) ? 0x2 : 0)
            + (Has(RoadLinkFlags.NarrowRoad) ? 0x200 : 0)
            + ((int)(link.MedianWidth ?? 15) * 0x1000)
            + (Has(RoadLinkFlags.DontUseForNavigation) ? 0x10000 : 0)
            + (Has(RoadLinkFlags.Shortcut) ? 0x20000 : 0)
            + (link.LanesBackward * 0x40000)
            + (link.LanesForward * 0x200000);
    }
}
