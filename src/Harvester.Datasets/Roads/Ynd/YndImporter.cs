using System;
using System.Collections.Generic;
using System.Linq;
using System.Xml.Linq;
using Harvester.Datasets.Files;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads.Ynd;

/// <summary>
/// Reads cells of path nodes as CodeWalker exports them (*.ynd.xml). Links to cells that are not among the files are skipped and counted; a
/// link to a node that is missing in its cell is an error.
/// </summary>
internal static class YndImporter
{
    private const string RootName = "NodeDictionary";
    private const int MaxId = ushort.MaxValue;

    /// <summary>Whether a file begins like such a cell.</summary>
    public static bool Understands(string head) =>
        head.StartsWith('<') && head.Contains("<" + RootName, StringComparison.Ordinal);

    public static RoadImport Import(IReadOnlyList<RoadSource> cells)
    {
        var assembly = new RoadAssembly();
        var indices = new Dictionary<(int Area, int Number), int>();
        var areas = new HashSet<int>();
        var links = new List<YndLink>();
        foreach (RoadSource cell in cells)
        {
            XElement root = RoadXml.Root(cell);
            IReadOnlyList<XElement> items = [.. root.Child(cell, "Nodes").Elements("Item")];
            int counted = Count(root, cell, "VehicleNodeCount") + Count(root, cell, "PedNodeCount");
            if (counted != items.Count)
            {
                throw RoadXml.Wrong(cell, root, $"the file counts {counted} nodes but has {items.Count}.");
            }

            foreach (XElement item in items)
            {
                RoadNode node = Node(cell, item);
                areas.Add(node.Area);
                if (!indices.TryAdd((node.Area, node.Number), assembly.NodeCount))
                {
                    throw RoadXml.Wrong(cell, item, $"node {node.Number} of cell {node.Area} occurs twice.");
                }

                links.AddRange((item.Element("Links")?.Elements("Item") ?? []).Select(link => Link(cell, link, assembly.NodeCount)));
                RoadAssembly.RequireRoom(links.Count / 2);
                assembly.Add(node);
            }
        }

        foreach (YndLink link in links)
        {
            if (indices.TryGetValue((link.ToArea, link.ToNumber), out int to))
            {
                assembly.Add(PathBits.Link(link.From, to, link.Bits));
            }
            else if (areas.Contains(link.ToArea))
            {
                throw new DatasetFormatException(
                    $"{link.Place}: the link leads to node {link.ToNumber} of cell {link.ToArea}, which that cell does not have.");
            }
            else
            {
                assembly.LeadsOutside();
            }
        }

        return assembly.Finish("CodeWalker ynd.xml");
    }

    private static int Count(XElement root, RoadSource cell, string name) =>
        root.Child(cell, name).Whole(cell, "value", 0, MaxId);

    private static RoadNode Node(RoadSource cell, XElement item)
    {
        int[] flags = [.. Enumerable.Range(0, 6).Select(i => Value(cell, item, $"Flags{i}", byte.MaxValue))];
        XElement position = item.Child(cell, "Position");
        string street = item.Element("StreetName")?.Value.Trim() ?? "";
        return new RoadNode(
            Value(cell, item, "AreaID", MaxId),
            Value(cell, item, "NodeID", MaxId),
            PathGrid.RemoveBias(new Vector3D(position.Number(cell, "x"), position.Number(cell, "y"), position.Number(cell, "z"))),
            street == "0" ? "" : street,
            PathBits.NodeFlags(flags))
        {
            Speed = PathBits.SpeedOf(flags[5]),
            Density = PathBits.DensityOf(flags[4]),
        };
    }

    private static YndLink Link(RoadSource cell, XElement item, int from)
    {
        int bits = Value(cell, item, "Flags0", byte.MaxValue)
            | (Value(cell, item, "Flags1", byte.MaxValue) << 8)
            | (Value(cell, item, "Flags2", byte.MaxValue) << 16);
        int line = ((System.Xml.IXmlLineInfo)item).LineNumber;
        return new YndLink(from, Value(cell, item, "ToAreaID", MaxId), Value(cell, item, "ToNodeID", MaxId),
            bits, $"{cell.Name}, line {line}");
    }

    private static int Value(RoadSource cell, XElement item, string name, int max) =>
        item.Child(cell, name).Whole(cell, "value", 0, max);
}
