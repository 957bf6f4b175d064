using System.Globalization;
using System.Text;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Roads;

/// <summary>Writes roads in the format of <see cref="RoadCsv"/>: the same network gives the same bytes in every runtime.</summary>
public static class RoadCsvWriter
{
    /// <summary>Writes a road network: nodes, links, then edges.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(RoadNetwork network, TextWriter text)
    {
        if (network is null)
        {
            throw new ArgumentNullException(nameof(network));
        }

        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        Line(text, RoadCsv.FirstLine);
        Line(text, RoadCsv.NodeColumns);
        foreach (RoadNode node in network.Nodes)
        {
            Line(
                text,
                "node",
                node.Area == RoadNode.NoArea ? string.Empty : Whole(node.Area),
                Whole(node.Number),
                Metres(node.Position.X),
                Metres(node.Position.Y),
                Metres(node.Position.Z),
                CsvFields.Quote(node.Street),
                RoadCsv.NodeFlags.Write((int)node.Flags),
                node.Speed is { } speed ? RoadCsv.NameOf(speed) : "",
                node.Density is { } density ? Whole(density) : ""
            );
        }

        Line(text, RoadCsv.LinkColumns);
        foreach (RoadLink link in network.Links)
        {
            Vector3D along = network.Nodes[link.To].Position - network.Nodes[link.From].Position;
            Line(
                text,
                "link",
                Whole(link.From),
                Whole(link.To),
                Whole(link.LanesForward),
                Whole(link.LanesBackward),
                link.MedianWidth is { } median ? Metres(median) : "",
                RoadCsv.LinkFlags.Write((int)link.Flags),
                Metres(along.Length)
            );
        }

        if (network.Edges.Count > 0)
        {
            Line(text, RoadCsv.EdgeColumns);
        }

        foreach (RoadEdge edge in network.Edges)
        {
            Line(
                text,
                "edge",
                Whole(edge.Link),
                edge.IsAtStart ? RoadCsv.Start : RoadCsv.End,
                Metres(edge.Point.X),
                Metres(edge.Point.Y),
                Metres(edge.Point.Z)
            );
        }

        Line(text, "end", Whole(network.Nodes.Count), Whole(network.Links.Count));
    }

    private static string Metres(double value)
    {
        var digits = new StringBuilder();
        InvariantNumber.Append(digits, value, RoadCsv.Decimals);
        return digits.ToString();
    }

    private static string Whole(int number) => number.ToString(CultureInfo.InvariantCulture);

    private static void Line(TextWriter text, params string[] fields) => text.Write(string.Join(",", fields) + "\n");
}
