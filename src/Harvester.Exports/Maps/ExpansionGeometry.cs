using System.Globalization;
using System.Text.Json;
using Harvester.Geometry;

namespace Harvester.Exports.Maps;

/// <summary>The nodes, lines and polygons of a nuScenes map. Nodes at one place, to a millimetre, are one node.</summary>
/// <param name="offset">What is added to a place in the world, metres.</param>
internal sealed class ExpansionGeometry(Vector2D offset)
{
    private const int Decimals = 3;
    private const double Steps = 1000;
    private readonly Dictionary<(long X, long Y), int> _numbers = [];
    private readonly List<(long X, long Y)> _nodes = [];
    private readonly List<(string Name, string Part, int[] Nodes)> _lines = [];
    private readonly List<(string Name, string Part, int[] Nodes)> _polygons = [];

    /// <summary>Adds a line through places in the world, and returns its token.</summary>
    /// <param name="name">The name of what it belongs to.</param>
    /// <param name="part">What it is of that.</param>
    /// <param name="places">Metres, world.</param>
    public string Line(string name, string part, IEnumerable<Vector2D> places)
    {
        _lines.Add((name, part, [.. places.Select(Node)]));
        return name + part;
    }

    /// <summary>Adds a polygon, and returns its token, as <see cref="Line"/>.</summary>
    public string Polygon(string name, string part, IEnumerable<Vector2D> places)
    {
        _polygons.Add((name, part, [.. places.Select(Node)]));
        return name + part;
    }

    /// <summary>The token of the node at a place in the world.</summary>
    public string NodeToken(Vector2D place) => NodeToken(Node(place));

    /// <summary>A place in the frame of the map, metres.</summary>
    public Vector2D Local(double x, double y) => new(Math.Round(x + offset.X, Decimals), Math.Round(y + offset.Y, Decimals));

    /// <summary>Writes the three layers; nothing may be added after.</summary>
    public void Write(ExpansionJson json)
    {
        json.List(
            "polygon",
            _polygons,
            polygon => WriteShape(json.Writer, polygon.Name + polygon.Part, "exterior_node_tokens", polygon.Nodes, hasHoles: true)
        );
        json.List("line", _lines, line => WriteShape(json.Writer, line.Name + line.Part, "node_tokens", line.Nodes, hasHoles: false));
        json.List(
            "node",
            _nodes.Select((node, number) => (Number: number, Node: node)),
            item =>
            {
                json.Writer.WriteString("token", NodeToken(item.Number));
                json.Writer.WriteNumber("x", item.Node.X / Steps);
                json.Writer.WriteNumber("y", item.Node.Y / Steps);
            }
        );
    }

    private int Node(Vector2D place)
    {
        Vector2D local = Local(place.X, place.Y);
        (long X, long Y) key = ((long)Math.Round(local.X * Steps), (long)Math.Round(local.Y * Steps));
        if (!_numbers.TryGetValue(key, out int number))
        {
            _numbers.Add(key, number = _nodes.Count);
            _nodes.Add(key);
        }

        return number;
    }

    private static string NodeToken(int number) => "n" + number.ToString(CultureInfo.InvariantCulture);

    private static void WriteShape(Utf8JsonWriter json, string token, string name, int[] nodes, bool hasHoles)
    {
        json.WriteString("token", token);
        json.WriteStartArray(name);
        foreach (int node in nodes)
        {
            json.WriteStringValue(NodeToken(node));
        }

        json.WriteEndArray();
        if (hasHoles)
        {
            json.WriteStartArray("holes");
            json.WriteEndArray();
        }
    }
}
