using System.Xml.Linq;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Ynd;

/// <summary>
/// Reads cells of path nodes as CodeWalker exports them (*.ynd.xml). Links to cells that are not among the files are skipped and counted; a
/// link to a node that is missing in its cell is an error. Of several files of one cell, the last counts, as in the game's updates.
/// </summary>
internal static class YndImporter
{
    private const string RootName = "NodeDictionary";
    private const int MaxId = ushort.MaxValue;

    /// <summary>Whether a file begins like such a cell.</summary>
    public static bool Understands(string head) => head.StartsWith('<') && head.Contains("<" + RootName, StringComparison.Ordinal);

    public static RoadImport Import(IReadOnlyList<RoadSource> cells)
    {
        var assembly = new RoadAssembly();
        var files = new SortedDictionary<int, YndCell>();
        var notes = new List<string>();
        int count = 0;
        foreach (RoadSource cell in cells)
        {
            foreach (YndCell read in Read(cell).Values)
            {
                if (files.TryGetValue(read.Area, out YndCell? former))
                {
                    notes.Add($"'{cell.Name}' replaces '{former.File}', which has the same cell {read.Area}.");
                }

                RoadAssembly.RequireRoom(count += read.Nodes.Count);
                files[read.Area] = read;
            }
        }

        var indices = new Dictionary<(int Area, int Number), int>();
        var links = new List<YndLink>();
        foreach (YndCell cell in files.Values)
        {
            foreach ((RoadNode node, IReadOnlyList<YndLink> ofNode) in cell.Nodes)
            {
                indices.Add((node.Area, node.Number), assembly.NodeCount);
                links.AddRange(ofNode.Select(link => link with { From = assembly.NodeCount }));
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
            else if (files.ContainsKey(link.ToArea))
            {
                throw new DatasetFormatException(
                    $"{link.Place}: the link leads to node {link.ToNumber} of cell {link.ToArea}, which that cell does not have."
                );
            }
            else
            {
                assembly.LeadsOutside();
            }
        }

        return assembly.Finish("CodeWalker ynd.xml", notes);
    }

    /// <summary>The cells of a file, by their number; a file has one as a rule.</summary>
    private static SortedDictionary<int, YndCell> Read(RoadSource file)
    {
        XElement root = RoadXml.Root(file);
        IReadOnlyList<XElement> items = [.. root.Child(file, "Nodes").Elements("Item")];
        int counted = Count(root, file, "VehicleNodeCount") + Count(root, file, "PedNodeCount");
        if (counted != items.Count)
        {
            throw RoadXml.Wrong(file, root, $"the file counts {counted} nodes but has {items.Count}.");
        }

        var cells = new SortedDictionary<int, YndCell>();
        var known = new HashSet<(int Area, int Number)>();
        foreach (XElement item in items)
        {
            RoadNode node = Node(file, item);
            if (!known.Add((node.Area, node.Number)))
            {
                throw RoadXml.Wrong(file, item, $"node {node.Number} of cell {node.Area} occurs twice.");
            }

            if (!cells.TryGetValue(node.Area, out YndCell? cell))
            {
                cell = new YndCell(file.Name, node.Area, []);
                cells.Add(node.Area, cell);
            }

            cell.Nodes.Add((node, [.. (item.Element("Links")?.Elements("Item") ?? []).Select(link => Link(file, link, from: 0))]));
        }

        return cells;
    }

    private static int Count(XElement root, RoadSource cell, string name) => root.Child(cell, name).Whole(cell, "value", 0, MaxId);

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
            PathBits.NodeFlags(flags)
        )
        {
            Speed = PathBits.SpeedOf(flags[5]),
            Density = PathBits.DensityOf(flags[4]),
        };
    }

    private static YndLink Link(RoadSource cell, XElement item, int from)
    {
        int bits =
            Value(cell, item, "Flags0", byte.MaxValue)
            | (Value(cell, item, "Flags1", byte.MaxValue) << 8)
            | (Value(cell, item, "Flags2", byte.MaxValue) << 16);
        int line = ((System.Xml.IXmlLineInfo)item).LineNumber;
        return new YndLink(
            from,
            Value(cell, item, "ToAreaID", MaxId),
            Value(cell, item, "ToNodeID", MaxId),
            bits,
            $"{cell.Name}, line {line}"
        );
    }

    private static int Value(RoadSource cell, XElement item, string name, int max) => item.Child(cell, name).Whole(cell, "value", 0, max);
}
