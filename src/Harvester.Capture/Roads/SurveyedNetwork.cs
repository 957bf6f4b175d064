using System;
using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Capture.Roads;

/// <summary>A network that grows. Nodes are known by their stored positions, which is all that the game's links name them by.</summary>
internal sealed class SurveyedNetwork
{
    private readonly List<RoadNode> _nodes = [];
    private readonly List<RoadLink> _links = [];
    private readonly Dictionary<Vector3D, int> _indices = [];
    private readonly HashSet<(int Low, int High)> _ends = [];

    public int NodeCount => _nodes.Count;

    public int LinkCount => _links.Count;

    public void Add(RoadNetwork earlier)
    {
        foreach (RoadNode node in earlier.Nodes)
        {
            Add(node, PathGrid.Truncate(node.Position));
        }

        foreach (RoadLink link in earlier.Links)
        {
            Add(link);
        }
    }

    public int? Find(Vector3D stored) => _indices.TryGetValue(Key(stored), out int index) ? index : null;

    public int Add(RoadNode node, Vector3D stored)
    {
        if (_indices.TryGetValue(Key(stored), out int known))
        {
            return known;
        }

        _indices.Add(Key(stored), _nodes.Count);
        _nodes.Add(node);
        return _nodes.Count - 1;
    }

    public void Add(RoadLink link)
    {
        if (link.From != link.To && _ends.Add((Math.Min(link.From, link.To), Math.Max(link.From, link.To))))
        {
            _links.Add(link);
        }
    }

    public RoadNetwork ToNetwork() => new([.. _nodes], [.. _links]);

    /// <summary>Without minus zero, whose hash is not that of zero in every runtime.</summary>
    private static Vector3D Key(Vector3D stored) => stored + Vector3D.Zero;
}
