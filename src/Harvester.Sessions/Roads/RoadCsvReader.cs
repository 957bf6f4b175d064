using System.Globalization;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Sessions.Roads;

/// <summary>
/// Reads roads in the format of <see cref="RoadCsv"/>, strictly: the first error ends the reading and is reported with its line.
/// </summary>
public sealed class RoadCsvReader
{
    private const int MaxLanes = 7;
    private const int MaxDensity = 15;

    /// <summary>Maximum number of nodes, links or edges: more than ten times as many as in the game.</summary>
    private const int MaxRows = 1_000_000;

    /// <summary>Maximum coordinate, metres: larger than any in the game's world, and written without loss.</summary>
    private const double MaxCoordinate = 100_000;

    private readonly List<RoadNode> _nodes = [];
    private readonly List<RoadLink> _links = [];
    private readonly List<RoadEdge> _edges = [];
    private int _line;
    private bool _ended;

    private RoadCsvReader() { }

    /// <summary>Reads a file to its end.</summary>
    /// <exception cref="FormatException">The file is invalid; the message names the line.</exception>
    /// <exception cref="IOException">The file cannot be read.</exception>
    public static RoadNetwork Read(TextReader text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        return new RoadCsvReader().ReadAll(text);
    }

    private RoadNetwork ReadAll(TextReader text)
    {
        while (text.ReadLine() is { } line)
        {
            _line++;
            if (_line == 1)
            {
                Require(line.TrimStart('\uFEFF') == RoadCsv.FirstLine, "the first line must be " + RoadCsv.FirstLine + ".");
            }
            else if (line.Length > 0 && line[0] != '#')
            {
                Require(!_ended, "nothing may follow the line that begins with end.");
                Require(
                    Math.Max(_nodes.Count, Math.Max(_links.Count, _edges.Count / 4)) < MaxRows,
                    FormattableString.Invariant($"more than {MaxRows} nodes or links; the game's road network is smaller.")
                );
                ReadRow(CsvFields.Split(line) ?? throw Wrong(CsvFields.Problem));
            }
        }

        Require(_ended, "the file ends before its last line, which begins with end.");
        return new RoadNetwork(_nodes, _links, _edges);
    }

    private void ReadRow(List<string> fields)
    {
        switch (fields[0])
        {
            case "node":
                Require(fields.Count == 10, "a node has 10 fields.");
                Require(_links.Count == 0 && _edges.Count == 0, "a node must come before all links and edges.");
                _nodes.Add(
                    new RoadNode(
                        fields[1].Length == 0 ? RoadNode.NoArea : Whole(fields[1], "area", 0, int.MaxValue),
                        Whole(fields[2], "number", 0, int.MaxValue),
                        Place(fields, 3),
                        fields[6],
                        (RoadNodeFlags)(RoadCsv.NodeFlags.Read(fields[7]) ?? throw Wrong("unknown flags: " + fields[7] + "."))
                    )
                    {
                        Speed = Speed(fields[8]),
                        Density = fields[9].Length == 0 ? null : Whole(fields[9], "density", 0, MaxDensity),
                    }
                );
                break;
            case "link":
                Require(fields.Count == 8, "a link has 8 fields.");
                Require(_edges.Count == 0, "a link must come before all edges.");
                int from = Whole(fields[1], "from", 0, _nodes.Count - 1);
                int to = Whole(fields[2], "to", 0, _nodes.Count - 1);
                Require(from != to, "a link must lead from one node to another.");
                _links.Add(
                    new RoadLink(
                        from,
                        to,
                        Whole(fields[3], "lanesForward", 0, MaxLanes),
                        Whole(fields[4], "lanesBackward", 0, MaxLanes),
                        fields[5].Length == 0 ? null : Metres(fields[5], "medianWidth"),
                        (RoadLinkFlags)(RoadCsv.LinkFlags.Read(fields[6]) ?? throw Wrong("unknown flags: " + fields[6] + "."))
                    )
                );
                break;
            case "edge":
                Require(fields.Count == 6, "an edge must have 6 fields.");
                Require(fields[2] is RoadCsv.Start or RoadCsv.End, "an edge must be at one end of its link: from or to.");
                _edges.Add(new RoadEdge(Whole(fields[1], "link", 0, _links.Count - 1), fields[2] == RoadCsv.Start, Place(fields, 3)));
                break;
            case "end":
                Require(fields.Count == 3, "the last line must have 3 fields.");
                Whole(fields[1], "the count of nodes", _nodes.Count, _nodes.Count);
                Whole(fields[2], "the count of links", _links.Count, _links.Count);
                _ended = true;
                break;
            default:
                throw Wrong("a line must begin with node, link, edge, end or #.");
        }
    }

    private RoadSpeed? Speed(string text)
    {
        if (text.Length == 0)
        {
            return null;
        }

        foreach (RoadSpeed speed in (RoadSpeed[])Enum.GetValues(typeof(RoadSpeed)))
        {
            if (string.Equals(RoadCsv.NameOf(speed), text, StringComparison.Ordinal))
            {
                return speed;
            }
        }

        throw Wrong("unknown speed: " + text + ".");
    }

    private int Whole(string text, string name, int minimum, int maximum) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value)
        && value >= minimum
        && value <= maximum
            ? value
            : throw Wrong(FormattableString.Invariant($"{name} must be a whole number from {minimum} to {maximum}, not {text}."));

    private Vector3D Place(List<string> fields, int first) =>
        new(Metres(fields[first], "x"), Metres(fields[first + 1], "y"), Metres(fields[first + 2], "z"));

    private double Metres(string text, string name) =>
        double.TryParse(
            text,
            NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint,
            CultureInfo.InvariantCulture,
            out double value
        )
        && Math.Abs(value) <= MaxCoordinate
            ? value
            : throw Wrong(FormattableString.Invariant($"{name} must be a number of at most {MaxCoordinate}, not {text}."));

    private void Require(bool condition, string what)
    {
        if (!condition)
        {
            throw Wrong(what);
        }
    }

    private FormatException Wrong(string what) => new(FormattableString.Invariant($"line {_line}: {what}"));
}
