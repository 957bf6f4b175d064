using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Maps;

/// <summary>Where the links within a junction lead.</summary>
internal sealed class JunctionPaths
{
    private readonly RoadNetwork _network;
    private readonly HashSet<int> _nodes;
    private readonly Predicate<int> _isWithin;
    private readonly Dictionary<int, HashSet<int>> _reached = [];

    /// <summary>Prepares the paths of a junction.</summary>
    /// <param name="network">The roads.</param>
    /// <param name="nodes">The junction's nodes.</param>
    /// <param name="isWithin">Whether a link between two of them is part of the junction from end to end.</param>
    public JunctionPaths(RoadNetwork network, IEnumerable<int> nodes, Predicate<int> isWithin) =>
        (_network, _nodes, _isWithin) = (network, [.. nodes], isWithin);

    /// <summary>
    /// Whether the links lead from the node of one arm to that of another, each in a direction in which it has lanes: the arms of a large
    /// junction may lie such that a car could drive from one into the other, across a median that the road data has.
    /// </summary>
    public bool Leads(JunctionArm arm, JunctionArm exit)
    {
        if (!_reached.TryGetValue(arm.Node, out HashSet<int>? reached))
        {
            _reached.Add(arm.Node, reached = ReachedFrom(arm.Node));
        }

        return reached.Contains(exit.Node);
    }

    private HashSet<int> ReachedFrom(int start)
    {
        var reached = new HashSet<int> { start };
        var open = new Stack<int>();
        open.Push(start);
        while (open.Count > 0)
        {
            int node = open.Pop();
            foreach (int link in _network.LinksOf(node))
            {
                RoadLink road = _network.Links[link];
                (int next, int lanes) = road.From == node ? (road.To, road.LanesForward) : (road.From, road.LanesBackward);
                if (
                    lanes > 0
                    && _nodes.Contains(next)
                    && RoadContinuations.IsDrivable(_network, road)
                    && _isWithin(link)
                    && reached.Add(next)
                )
                {
                    open.Push(next);
                }
            }
        }

        return reached;
    }
}
