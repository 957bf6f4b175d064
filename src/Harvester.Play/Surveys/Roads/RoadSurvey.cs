using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Play.Surveys.Roads;

/// <summary>
/// Collects the road network around a car while it drives, with a few calls to the game per tick. Nodes come from the list of those closest
/// to the car; links are searched at eight points around every node, since the game only returns the one closest to a point. A link that is
/// nowhere closer than its neighbours is not found. For the edges of a link the game is called twice, ticks apart, at both of its ends,
/// looking along it; <see cref="LaneModel"/> decides whether the results can be trusted.
/// </summary>
public sealed class RoadSurvey
{
    /// <summary>Distance around the car within which nodes are surveyed, metres.</summary>
    public const double Range = 150;

    /// <summary>
    /// Points around a node, and their distance from it in metres: far enough for its links to be apart, nearer than the next node.
    /// </summary>
    private const int Probes = 8;
    private const double ProbeDistance = 3;

    private const int MaxLanes = 7;

    /// <summary>Maximum distance of an edge point from its node, metres; a farther one belongs to another road.</summary>
    private const double MaxEdgeDistance = 100;

    /// <summary>Number of calls for the edges of a link at each of its two ends.</summary>
    private const int EdgeRounds = 2;

    /// <summary>The handle of node 0 of cell 0, for an end of a link for which the game gives no handle.</summary>
    private const int UnknownHandle = 1;

    private const int MinCalls = 16;

    private readonly IRoadSource _source;
    private readonly int _callsPerStep;
    private readonly SurveyedNetwork _network = new();
    private readonly HashSet<int> _met = [];
    private readonly Queue<(int Node, Vector3D Stored)> _waiting = new();
    private readonly HashSet<int> _linksMet = [];
    private readonly Queue<(int Link, int Rounds)> _unmeasured = new();
    private int _nextNumber = 1;
    private int _nextProbe;
    private int _calls;

    /// <summary>Creates a survey. The game is not used before the first step.</summary>
    /// <param name="source">The game's functions for nodes and links.</param>
    /// <param name="earlier">The result of an earlier survey, to continue it; null to start a new one.</param>
    /// <param name="callsPerStep">Maximum number of calls to the game per tick; at least 16.</param>
    public RoadSurvey(IRoadSource source, RoadNetwork? earlier = null, int callsPerStep = 40)
    {
        _source = source ?? throw new ArgumentNullException(nameof(source));
        if (callsPerStep < MinCalls)
        {
            throw new ArgumentOutOfRangeException(nameof(callsPerStep), callsPerStep, "A step may ask at least 16 times.");
        }

        _callsPerStep = callsPerStep;
        if (earlier is not null)
        {
            _network.Add(earlier);
        }
    }

    /// <summary>Continues the survey; call it every tick, because the game forgets requests to load nodes.</summary>
    /// <param name="place">The car's position, metres, world.</param>
    public RoadSurveyStatus Step(Vector3D place)
    {
        bool isLoaded = _source.RequestNodes(place, Range);
        if (isLoaded)
        {
            _calls = 0;
            int unmeasured = _unmeasured.Count;
            while (_waiting.Count > 0 && _calls < _callsPerStep / 2)
            {
                ProbeNext();
            }

            while (unmeasured-- > 0 && _calls < _callsPerStep * 3 / 4)
            {
                MeasureNext(place);
            }

            // A node takes two calls.
            while (_calls < _callsPerStep - 2 && MeetNext(place)) { }
        }

        return new RoadSurveyStatus(
            _network.NodeCount,
            _network.LinkCount,
            _network.EdgeCount,
            _waiting.Count + _unmeasured.Count,
            isLoaded
        );
    }

    /// <summary>Everything found so far, including the earlier survey.</summary>
    public RoadNetwork ToNetwork() => _network.ToNetwork();

    /// <summary>
    /// Surveys the next node around the car; after the last, and when the car has moved on, it begins again with the closest.
    /// </summary>
    private bool MeetNext(Vector3D place)
    {
        _calls++;
        if (_source.NthClosestNode(place, _nextNumber) is not { } node || (node.Position - place).Length > Range)
        {
            _nextNumber = 1;
            return false;
        }

        _nextNumber++;
        Meet(node);
        return true;
    }

    private void Meet(SurveyedNode node)
    {
        int index = _network.Find(node.Position) ?? _network.Add(Describe(node), node.Position);
        if (_met.Add(index))
        {
            _waiting.Enqueue((index, node.Position));
        }
    }

    private RoadNode Describe(SurveyedNode node)
    {
        _calls++;
        SurveyedProperties? properties = _source.ReadProperties(node.Position);
        uint handle = (uint)node.Handle - 1;
        return new RoadNode(
            (int)(handle & ushort.MaxValue),
            (int)(handle >> 16),
            PathGrid.RemoveBias(node.Position),
            "",
            PathBits.FlagsOfProperties(properties?.Flags ?? 0)
        )
        {
            Density = properties?.Density,
        };
    }

    private void ProbeNext()
    {
        (int node, Vector3D stored) = _waiting.Peek();
        double angle = 2 * Math.PI * _nextProbe / Probes;
        _calls++;
        var probe = new Vector3D(stored.X + (ProbeDistance * Math.Cos(angle)), stored.Y + (ProbeDistance * Math.Sin(angle)), stored.Z);
        if (_source.ClosestRoad(probe) is { } road && IsSound(road))
        {
            Meet(
                new RoadLink(
                    End(road.First, node, stored),
                    End(road.Second, node, stored),
                    road.LanesToSecond,
                    road.LanesToFirst,
                    road.MedianWidth < 0 ? null : road.MedianWidth,
                    RoadLinkFlags.None
                )
            );
        }

        _nextProbe = (_nextProbe + 1) % Probes;
        if (_nextProbe == 0)
        {
            _waiting.Dequeue();
        }
    }

    private void Meet(RoadLink road)
    {
        if (_network.Add(road) is { } link && _linksMet.Add(link) && _network.EdgesOf(link) < 2 * EdgeRounds)
        {
            _unmeasured.Enqueue((link, EdgeRounds - (_network.EdgesOf(link) / 2)));
        }
    }

    private void MeasureNext(Vector3D place)
    {
        (int link, int rounds) = _unmeasured.Dequeue();
        RoadLink road = _network.Link(link);
        Vector3D start = PathGrid.Truncate(_network.Node(road.From).Position);
        Vector3D end = PathGrid.Truncate(_network.Node(road.To).Position);

        // Far away the game has no node, and would return the edge of another: such a link waits until the car is near both its ends.
        if ((start - place).Length > Range || (end - place).Length > Range)
        {
            _unmeasured.Enqueue((link, rounds));
            return;
        }

        Measure(link, isAtStart: true, start, end - start);
        Measure(link, isAtStart: false, end, start - end);
        if (rounds > 1)
        {
            _unmeasured.Enqueue((link, rounds - 1));
        }
    }

    private void Measure(int link, bool isAtStart, Vector3D node, Vector3D along)
    {
        _calls++;
        if (_source.RoadEdge(node, Angles.HeadingDegrees(along)) is { } edge && (edge - node).Length < MaxEdgeDistance)
        {
            _network.Add(new RoadEdge(link, isAtStart, edge + (PathGrid.RemoveBias(node) - node)));
        }
    }

    private static bool IsSound(SurveyedRoad road) =>
        road.First.IsFinite
        && road.Second.IsFinite
        && road.LanesToFirst is >= 0 and <= MaxLanes
        && road.LanesToSecond is >= 0 and <= MaxLanes;

    /// <summary>The node at an end of a link. Its own links wait until the car is near, when the game lists it.</summary>
    private int End(Vector3D end, int node, Vector3D stored)
    {
        if (end == stored)
        {
            return node;
        }

        if (_network.Find(end) is { } known)
        {
            return known;
        }

        _calls++;
        SurveyedNode? closest = _source.NthClosestNode(end, 1);
        return _network.Add(Describe(closest is { } there && there.Position == end ? there : new SurveyedNode(UnknownHandle, end)), end);
    }
}
