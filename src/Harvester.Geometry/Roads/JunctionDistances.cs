using System;
using System.Collections.Generic;

namespace Harvester.Geometry.Roads;

/// <summary>
/// How far each node is from the next junction along drivable links. A junction is a node that the path data calls so, or where
/// more than two drivable links meet.
/// </summary>
internal sealed class JunctionDistances
{
    private readonly RoadNetwork _network;
    private readonly double[] _distances;

    public JunctionDistances(RoadCurves curves, double furthest)
    {
        _network = curves.Network;
        _distances = new double[_network.Nodes.Count];
        var waiting = new Queue<int>();
        for (int node = 0; node < _distances.Length; node++)
        {
            bool isJunction = IsJunction(node);
            _distances[node] = isJunction ? 0 : double.PositiveInfinity;
            if (isJunction)
            {
                waiting.Enqueue(node);
            }
        }

        while (waiting.Count > 0)
        {
            int node = waiting.Dequeue();
            foreach (int link in _network.LinksOf(node))
            {
                RoadLink road = _network.Links[link];
                int other = road.From == node ? road.To : road.From;
                double distance = _distances[node] + curves.Of(link).Length;
                if (distance < furthest && distance < _distances[other] && RoadContinuations.IsDrivable(_network, road))
                {
                    _distances[other] = distance;
                    waiting.Enqueue(other);
                }
            }
        }
    }

    /// <summary>Metres along the road to the next junction from a place on a link; infinite beyond the furthest asked for.</summary>
    public double From(RoadLink link, double station, double length) =>
        Math.Min(_distances[link.From] + station, _distances[link.To] + length - station);

    /// <summary>Whether a node is a junction.</summary>
    public bool IsJunction(int node)
    {
        int drivable = 0;
        foreach (int link in _network.LinksOf(node))
        {
            drivable += RoadContinuations.IsDrivable(_network, _network.Links[link]) ? 1 : 0;
        }

        return drivable > 2 || (drivable > 0 && (_network.Nodes[node].Flags & RoadNodeFlags.Junction) != 0);
    }
}
