using System;
using System.Collections.Generic;
using System.Linq;

namespace Harvester.Geometry.Roads;

/// <summary>
/// How far junctions reach along the links that meet in them. A junction is a node where more than two drivable links meet, or that
/// the path data calls so. Along each link it reaches to where the edge of the carriageway leaves those of its neighbours, and on by
/// the room for corners and stop lines; where a link is shorter than that, on along the link that continues it.
/// </summary>
public sealed class JunctionExtents
{
    /// <summary>Between the crossing of the edges and the first place with lanes of its own, metres: the radius of a corner.</summary>
    private const double CornerRoom = 1.5;

    /// <summary>Roads that part at so small an angle that their edges never cross: a junction reaches no further, metres.</summary>
    private const double Furthest = 30;

    /// <summary>
    /// Roads that meet at a smaller angle than this merge or go on in one another, and do not cross, radians: 35 degrees.
    /// </summary>
    private const double MergingAngle = 0.6;

    /// <summary>
    /// The greatest length of a link between two carriageways, metres: enough to cross a median and two lanes at an angle.
    /// </summary>
    private const double MaxTie = 40;

    private readonly RoadCurves _curves;
    private readonly RoadNetwork _network;
    private readonly LaneModel _lanes;
    private readonly double[] _fromStart;
    private readonly double[] _fromEnd;

    /// <summary>Measures the junctions of a network.</summary>
    /// <param name="curves">The centre lines.</param>
    /// <param name="lanes">How wide the roads are.</param>
    public JunctionExtents(RoadCurves curves, LaneModel lanes)
    {
        _curves = Guard.NotNull(curves, nameof(curves));
        _network = curves.Network;
        _lanes = Guard.NotNull(lanes, nameof(lanes));
        _fromStart = new double[_network.Links.Count];
        _fromEnd = new double[_network.Links.Count];
        for (int node = 0; node < _network.Nodes.Count; node++)
        {
            List<int> arms = DrivableAt(_network, node);
            List<int> roads = [.. arms.Where(arm => !IsTie(arm))];
            if (IsJunction(_network, node, roads.Count))
            {
                foreach (int road in roads)
                {
                    Cover(node, road, Reach(node, road, roads));
                }
            }

            foreach (int tie in arms.Except(roads))
            {
                Cover(node, tie, _curves.Of(tie).Length);
            }
        }
    }

    /// <summary>Whether a node is a junction.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="node">Index of the node.</param>
    public static bool IsJunction(RoadNetwork network, int node) => IsJunction(network, node, DrivableAt(network, node).Count);

    /// <summary>
    /// How far junctions reach into a link from its start and from its end, metres; 0 where there is none, more than its length where it
    /// lies in one.
    /// </summary>
    /// <param name="link">Index of the link.</param>
    public (double FromStart, double FromEnd) Of(int link) => (_fromStart[link], _fromEnd[link]);

    /// <summary>Whether a place on a link lies in a junction.</summary>
    /// <param name="link">Index of the link.</param>
    /// <param name="station">Metres from the link's start.</param>
    public bool Contains(int link, double station) =>
        station < _fromStart[link] || station > _curves.Of(link).Length - _fromEnd[link];

    private static bool IsJunction(RoadNetwork network, int node, int arms) =>
        arms > 2 || (arms > 0 && (network.Nodes[node].Flags & RoadNodeFlags.Junction) != 0);

    private static List<int> DrivableAt(RoadNetwork network, int node)
    {
        var links = new List<int>();
        foreach (int link in network.LinksOf(node))
        {
            if (RoadContinuations.IsDrivable(network, network.Links[link]))
            {
                links.Add(link);
            }
        }

        return links;
    }

    /// <summary>
    /// Whether a link only ties two carriageways that run side by side, so that cars can change over: roads that go on there have their
    /// lanes beside it. It lies between lanes itself, and counts as a junction from end to end.
    /// </summary>
    private bool IsTie(int link)
    {
        RoadLink road = _network.Links[link];
        return _curves.Of(link).Length <= MaxTie
            && DirectionThrough(road.From, link) is { } here && DirectionThrough(road.To, link) is { } there
            && Math.Abs(here.Cross(there)) < Math.Sin(MergingAngle);
    }

    /// <summary>
    /// The direction of the road that goes on through a node past a link; null where none does, or the path data calls the node a junction.
    /// </summary>
    private Vector2D? DirectionThrough(int node, int link)
    {
        if ((_network.Nodes[node].Flags & RoadNodeFlags.Junction) == 0)
        {
            foreach (int other in DrivableAt(_network, node))
            {
                int next = Next(node, other);
                if (other != link && next != RoadContinuations.None && next != link)
                {
                    return Outward(node, other);
                }
            }
        }

        return null;
    }

    /// <summary>Marks the first metres of a road that leaves a junction; beyond the end of a link the road's next one.</summary>
    private void Cover(int node, int link, double reach)
    {
        while (true)
        {
            bool leavesForward = _network.Links[link].From == node;
            double[] covered = leavesForward ? _fromStart : _fromEnd;
            covered[link] = Math.Max(covered[link], reach);
            reach -= _curves.Of(link).Length;
            node = leavesForward ? _network.Links[link].To : _network.Links[link].From;
            link = _curves.Continuations.Of(link, beyondEnd: leavesForward);
            if (reach <= 0 || link == RoadContinuations.None)
            {
                return;
            }
        }
    }

    /// <summary>
    /// Where the last corner of a link with a neighbour lies, metres along it: two edges that lie a and b beside lines which part at an
    /// angle t cross (b + a cos t) / sin t from the lines' common point.
    /// </summary>
    private double Reach(int node, int link, List<int> arms)
    {
        Vector2D along = Outward(node, link);
        bool goesOn = GoesOn(node, link);
        double furthest = 0;
        foreach (int other in arms)
        {
            Vector2D beside = Outward(node, other);
            double angle = Math.Atan2(along.Cross(beside), along.Dot(beside));
            bool isMerging = Math.Abs(angle) < MergingAngle && goesOn;
            if (other == link || isMerging || Math.Abs(angle) > Math.PI - MergingAngle)
            {
                continue;
            }

            bool isOnLeft = angle > 0;
            double sine = Math.Sin(Math.Abs(angle));
            double corner = Edge(node, other, onLeft: !isOnLeft) + (Edge(node, link, isOnLeft) * Math.Cos(angle));
            furthest = Math.Max(furthest, CornerRoom + (corner < Furthest * sine ? corner / sine : Furthest));
        }

        return furthest;
    }

    /// <summary>Whether a road goes on through a node with the lanes that it has: those of a road that merges end there instead.</summary>
    private bool GoesOn(int node, int link)
    {
        RoadLink road = _network.Links[link].To == node ? _network.Links[link] : _network.Links[link].Reversed();
        int next = Next(node, link);
        if (next == RoadContinuations.None)
        {
            return false;
        }

        RoadLink onwards = _network.Links[next].From == node ? _network.Links[next] : _network.Links[next].Reversed();
        return road.LanesForward == onwards.LanesForward && road.LanesBackward == onwards.LanesBackward;
    }

    /// <summary>The link that continues a link beyond a node.</summary>
    private int Next(int node, int link) => _curves.Continuations.Of(link, beyondEnd: _network.Links[link].To == node);

    private Vector2D Outward(int node, int link)
    {
        bool isStart = _network.Links[link].From == node;
        return _curves.Of(link).DirectionAt(isStart ? 0 : 1) * (isStart ? 1 : -1);
    }

    /// <summary>How far an edge of a link's carriageway lies beside its line, looking away from a node, metres.</summary>
    private double Edge(int node, int link, bool onLeft)
    {
        bool looksForward = _network.Links[link].From == node;
        bool keepsRight = !onLeft;
        if (_lanes.LanesOf(link, looksForward == keepsRight) is { } lanes)
        {
            return lanes.LeftEdge + (lanes.Section.LaneCount * lanes.Section.LaneWidth);
        }

        // A one-way road driven the other way: it is as wide on either side of its line.
        return _lanes.LanesOf(link, looksForward != keepsRight) is { } oneWay ? -oneWay.LeftEdge : 0;
    }
}
