using System.Text.Json;
using Harvester.Datasets.Roads.Sources;
using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Datasets.Roads.JsonDump;

/// <summary>
/// Reads the public JSON dump of the game's nodes: a list of cells, each with its nodes and their neighbours. A neighbour is identified by
/// its number and position, because its cell is not given. The dump has no medians, narrow roads or shortcuts.
/// </summary>
internal static class JsonDumpImporter
{
    private const string Format = "JSON dump of nodes";

    /// <summary>The dump has 8 levels of nesting.</summary>
    private const int MaxNesting = 16;

    private const int MaxLanes = 7;

    /// <summary>Largest size of a cell, bytes; those of the game have about 150,000 on average.</summary>
    private const int MaxAreaBytes = 16 << 20;

    private static readonly JsonSerializerOptions Options = new() { MaxDepth = MaxNesting, RespectNullableAnnotations = true };

    /// <summary>Whether the beginning of a file is that of a list of cells, not of another list of the game's data.</summary>
    public static bool Understands(string head) => head.StartsWith('[') && head.Contains("\"AreaId\"", StringComparison.Ordinal);

    public static RoadImport Import(RoadSource source)
    {
        var assembly = new RoadAssembly();
        var indices = new Dictionary<(int Number, DumpPosition Position), int>();
        var areas = new HashSet<int>();
        var neighbours = new List<(int From, DumpConnection Connection)>();
        foreach (DumpArea area in Areas(source))
        {
            if (!areas.Add(area.AreaId))
            {
                throw new DatasetFormatException($"{source.Name}: cell {area.AreaId} occurs twice.");
            }

            foreach (DumpNode node in area.Nodes)
            {
                if (node is null)
                {
                    throw new DatasetFormatException($"{source.Name}: a node of cell {area.AreaId} is null.");
                }

                Add(assembly, indices, neighbours, node, area.AreaId, source.Name);
            }
        }

        foreach ((int from, DumpConnection connection) in neighbours)
        {
            if (indices.TryGetValue((connection.Node.Id, connection.Node.Position), out int to))
            {
                assembly.Add(new RoadLink(from, to, connection.LaneCountForward, connection.LaneCountBackward, null, RoadLinkFlags.None));
            }
            else if (areas.Contains(PathGrid.CellOf(Vector(connection.Node.Position))))
            {
                throw new DatasetFormatException(
                    $"{source.Name}: {Name(assembly.Nodes[from])} has a neighbour, node {connection.Node.Id} at "
                        + $"{connection.Node.Position}, that is not in the file."
                );
            }
            else
            {
                assembly.LeadsOutside();
            }
        }

        return assembly.Finish(Format);
    }

    private static void Add(
        RoadAssembly assembly,
        Dictionary<(int Number, DumpPosition Position), int> indices,
        List<(int From, DumpConnection Connection)> neighbours,
        DumpNode node,
        int area,
        string file
    )
    {
        int index = assembly.NodeCount;
        string street = node.StreetName is null or "0" ? "" : node.StreetName;
        var roadNode = new RoadNode(area, node.Id, PathGrid.RemoveBias(Vector(node.Position)), street, node.Flags());
        assembly.Add(roadNode);
        if (!indices.TryAdd((node.Id, node.Position), index))
        {
            throw new DatasetFormatException($"{file}: {Name(roadNode)} occurs twice.");
        }

        foreach (DumpConnection connection in node.ConnectedNodes ?? [])
        {
            if (connection is null || connection.LaneCountForward is < 0 or > MaxLanes || connection.LaneCountBackward is < 0 or > MaxLanes)
            {
                throw new DatasetFormatException(
                    $"{file}: {Name(roadNode)} has a link without a number of lanes from 0 to {MaxLanes} each way."
                );
            }

            RoadAssembly.RequireRoom(neighbours.Count / 2);
            neighbours.Add((index, connection));
        }
    }

    private static IEnumerable<DumpArea> Areas(RoadSource source)
    {
        using Stream stream = source.Open(new JsonElementLimit(source.Name, MaxAreaBytes));
        IAsyncEnumerable<DumpArea?> areas = JsonSerializer.DeserializeAsyncEnumerable<DumpArea>(stream, Options);
        IAsyncEnumerator<DumpArea?> enumerator = areas.GetAsyncEnumerator();
        while (Next(source, enumerator))
        {
            yield return enumerator.Current ?? throw new DatasetFormatException($"{source.Name}: a cell is null.");
        }
    }

    private static bool Next(RoadSource source, IAsyncEnumerator<DumpArea?> enumerator)
    {
        try
        {
            ValueTask<bool> next = enumerator.MoveNextAsync();
            return next.IsCompletedSuccessfully ? next.Result : next.AsTask().GetAwaiter().GetResult();
        }
        catch (JsonException e)
        {
            throw new DatasetFormatException($"{source.Name}: {JsonFault.InText(e)}", e);
        }
    }

    private static Vector3D Vector(DumpPosition position) => new(position.X, position.Y, position.Z);

    private static string Name(RoadNode node) => $"node {node.Number} of cell {node.Area}";
}
