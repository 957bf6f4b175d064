using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>
/// Where roads end for junctions, and which nodes are one junction. Nodes between which a link lies within junctions from end to end are
/// one.
/// </summary>
internal sealed class JunctionGroups
{
    /// <summary>
    /// Length of road left to a junction, metres, where its extent is shorter because roads part or merge at a small angle: a way from one
    /// lane to another needs some length.
    /// </summary>
    private const double MinReach = 8;

    /// <summary>The largest part of a link that this takes at either end.</summary>
    private const double MaxFraction = 0.3;

    /// <summary>A shorter rest of a link between junctions is part of them, metres.</summary>
    private const double MinRest = 1;

    /// <summary>Edges of lanes that go on at most this far aside do not jump, metres.</summary>
    private const double MaxJump = 0.005;

    private readonly RoadNetwork _network;
    private readonly int[] _group;
    private readonly SortedDictionary<int, List<int>> _junctions = [];
    private readonly (double FromStart, double FromEnd)[] _trims;

    public JunctionGroups(RoadCurves curves, LaneModel lanes)
    {
        _network = curves.Network;
        var extents = new JunctionExtents(curves, lanes);
        _group = [.. Enumerable.Range(0, _network.Nodes.Count)];
        _trims = new (double, double)[_network.Links.Count];
        for (int link = 0; link < _trims.Length; link++)
        {
            RoadLink road = _network.Links[link];
            double length = curves.Of(link).Length;
            (double fromStart, double fromEnd) = extents.Of(link);
            fromStart = AtLeast(road.From, fromStart, length);
            fromEnd = AtLeast(road.To, fromEnd, length);
            _trims[link] = (fromStart, fromEnd);
            if (RoadContinuations.IsDrivable(_network, road) && !HasRest(link, length))
            {
                Join(road.From, road.To);
            }
        }

        FindJunctions();
        FindChanges(curves, lanes);
        LeaveRoom(curves);
    }

    private void FindJunctions()
    {
        foreach (IGrouping<int, int> nodes in _group.Select((_, node) => node).GroupBy(GroupOf))
        {
            if (nodes.Count() > 1 || JunctionExtents.IsJunction(_network, nodes.Key))
            {
                _junctions.Add(nodes.Key, [.. nodes]);
            }
        }
    }

    /// <summary>The nodes of each junction, ascending, by its least node.</summary>
    public IReadOnlyDictionary<int, List<int>> NodesOf => _junctions;

    /// <summary>
    /// Adds the nodes where a road goes on with other lanes, as many or as wide: there, ways lead from lane to lane, without a jump.
    /// </summary>
    private void FindChanges(RoadCurves curves, LaneModel lanes)
    {
        for (int link = 0; link < _network.Links.Count; link++)
        {
            NoteChange(curves, lanes, link, atEnd: false);
            NoteChange(curves, lanes, link, atEnd: true);
        }
    }

    private void NoteChange(RoadCurves curves, LaneModel lanes, int link, bool atEnd)
    {
        int node = atEnd ? _network.Links[link].To : _network.Links[link].From;
        int next = curves.Continuations.Of(link, atEnd);
        if (next == RoadContinuations.None || JunctionOf(node) is not null)
        {
            return;
        }

        bool atStartOfNext = _network.Links[next].From == node;
        double here = atEnd ? curves.Of(link).Length : 0;
        double there = atStartOfNext ? 0 : curves.Of(next).Length;
        bool AreSameIn(bool isForward) =>
            AreSame(lanes.LanesOf(link, isForward, here), lanes.LanesOf(next, isForward == (atEnd == atStartOfNext), there));
        if (!AreSameIn(isForward: true) || !AreSameIn(isForward: false))
        {
            // Nodes that are joined are a junction already.
            _junctions.Add(node, [node]);
        }
    }

    private static bool AreSame((LaneSection Section, double LeftEdge)? one, (LaneSection Section, double LeftEdge)? other) =>
        (one, other) switch
        {
            ({ } a, { } b) => a.Section.LaneCount == b.Section.LaneCount
                && Enumerable
                    .Range(0, a.Section.LaneCount + 1)
                    .All(edge => Math.Abs(a.LeftEdge + a.Section.Edge(edge) - b.LeftEdge - b.Section.Edge(edge)) <= MaxJump),
            _ => one is null && other is null,
        };

    /// <summary>The parts of a link that junctions take at its start and its end, metres.</summary>
    public (double FromStart, double FromEnd) TrimsOf(int link) => _trims[link];

    /// <summary>Whether anything of a link lies outside junctions.</summary>
    public bool HasRest(int link, double length) => length - _trims[link].FromStart - _trims[link].FromEnd >= MinRest;

    /// <summary>The least node of the junction that a node belongs to; null if it belongs to none.</summary>
    public int? JunctionOf(int node) => _junctions.ContainsKey(GroupOf(node)) ? GroupOf(node) : null;

    /// <summary>
    /// Leaves room for ways at the nodes that are part of a junction because short links connect them to it: no junction by themselves,
    /// they have no extent.
    /// </summary>
    private void LeaveRoom(RoadCurves curves)
    {
        for (int link = 0; link < _trims.Length; link++)
        {
            double length = curves.Of(link).Length;
            double room = Math.Min(MinReach, MaxFraction * length);
            (double fromStart, double fromEnd) = _trims[link];
            double longerStart = JunctionOf(_network.Links[link].From) is null ? fromStart : Math.Max(fromStart, room);
            double longerEnd = JunctionOf(_network.Links[link].To) is null ? fromEnd : Math.Max(fromEnd, room);
            if (length - longerStart - longerEnd >= MinRest)
            {
                _trims[link] = (longerStart, longerEnd);
            }
        }
    }

    private int GroupOf(int node)
    {
        while (_group[node] != node)
        {
            // Halves the path to the first node of the group.
            _group[node] = _group[_group[node]];
            node = _group[node];
        }

        return node;
    }

    private double AtLeast(int node, double extent, double length) =>
        JunctionExtents.IsJunction(_network, node) ? Math.Max(extent, Math.Min(MinReach, MaxFraction * length)) : extent;

    private void Join(int a, int b)
    {
        (int first, int second) = (GroupOf(a), GroupOf(b));
        _group[Math.Max(first, second)] = Math.Min(first, second);
    }
}
