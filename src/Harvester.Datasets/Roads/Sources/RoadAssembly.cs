using System.Globalization;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Reading.Files;

namespace Harvester.Datasets.Roads.Sources;

/// <summary>
/// Builds a network from the nodes and links that an importer finds. Sources that store a link at both of its ends give it twice, with the
/// lanes exchanged; it is added once.
/// </summary>
internal sealed class RoadAssembly
{
    /// <summary>
    /// Limit of nodes and of links, far above what the game's format can number, so that reading a hostile file ends early.
    /// </summary>
    private const int MaxCount = 1_000_000;

    private readonly List<RoadNode> _nodes = [];
    private readonly List<RoadLink> _links = [];
    private readonly Dictionary<(int Low, int High), int> _linkOfEnds = [];
    private int _contradictions;
    private int _repetitions;
    private int _loops;
    private int _leadOutside;

    /// <summary>Number of nodes; also the index of the next node.</summary>
    public int NodeCount => _nodes.Count;

    /// <summary>The nodes so far.</summary>
    public IReadOnlyList<RoadNode> Nodes => _nodes;

    /// <summary>Adds a node.</summary>
    public void Add(RoadNode node)
    {
        if (_nodes.Count >= MaxCount)
        {
            throw new DatasetFormatException($"more than {MaxCount} nodes, the limit.");
        }

        if (!node.Position.IsFinite)
        {
            throw new DatasetFormatException("the position of a node must be finite.");
        }

        _nodes.Add(node);
    }

    /// <summary>Adds a link as in its source. A second link between the same nodes is the first one seen from its other end.</summary>
    public void Add(RoadLink link)
    {
        if (link.From == link.To)
        {
            _loops++;
            return;
        }

        (int, int) ends = link.From < link.To ? (link.From, link.To) : (link.To, link.From);
        if (_linkOfEnds.TryGetValue(ends, out int other))
        {
            CountSecond(_links[other], link);
            return;
        }

        RequireRoom(_links.Count);
        _linkOfEnds.Add(ends, _links.Count);
        _links.Add(link);
    }

    /// <summary>Throws if the network already has the largest number of links.</summary>
    /// <param name="count">Number of links so far.</param>
    public static void RequireRoom(int count)
    {
        if (count >= MaxCount)
        {
            throw new DatasetFormatException($"more than {MaxCount} links, the limit.");
        }
    }

    /// <summary>Counts a link to a cell that is not among the files.</summary>
    public void LeadsOutside() => _leadOutside++;

    /// <summary>Completes the import.</summary>
    public RoadImport Finish(string format, params IEnumerable<string> furtherNotes)
    {
        var notes = new List<string>(furtherNotes);
        Note(notes, _leadOutside, "links to cells without a file, left out");
        Note(notes, _contradictions, "links with contradictory data at their two ends, of which the data read first was used");
        Note(notes, _repetitions, "links that occur twice, imported once");
        Note(notes, _loops, "links from a node to itself, left out");
        return new RoadImport(new RoadNetwork(_nodes, _links), format, notes);
    }

    private static void Note(List<string> notes, int count, string what)
    {
        if (count > 0)
        {
            notes.Add(string.Create(CultureInfo.InvariantCulture, $"{what}: {count}."));
        }
    }

    private void CountSecond(RoadLink first, RoadLink second)
    {
        bool mirrored = first.From == second.To;
        RoadLink sameWay = mirrored ? second.Reversed() : second;
        if (sameWay != first)
        {
            _contradictions++;
        }
        else if (!mirrored)
        {
            _repetitions++;
        }
    }
}
