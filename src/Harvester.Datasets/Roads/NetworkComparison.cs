using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.Datasets.Roads;

/// <summary>
/// Compares the directions of traffic in two road networks. A link is matched with the link of the other network on which its midpoint lies
/// and to which it is nearly parallel, so the networks need not have the same nodes.
/// </summary>
public sealed class NetworkComparison
{
    /// <summary>
    /// Largest distance of a link's midpoint from the matching link, metres: truncated positions are off by up to 0.25 m along each axis.
    /// </summary>
    private const double SamePlace = 2;

    /// <summary>Cosine of the largest angle between matching links, 20 degrees.</summary>
    private const double MinAlong = 0.94;

    private const double CellMetres = 64;

    private readonly RoadNetwork _network;
    private readonly Dictionary<(int Column, int Row), List<int>> _cells = [];

    private NetworkComparison(RoadNetwork network)
    {
        _network = network;
        for (int i = 0; i < network.Links.Count; i++)
        {
            (Vector3D a, Vector3D b) = Ends(network, network.Links[i]);
            (int fromColumn, int fromRow) = Cell(Math.Min(a.X, b.X) - SamePlace, Math.Min(a.Y, b.Y) - SamePlace);
            (int toColumn, int toRow) = Cell(Math.Max(a.X, b.X) + SamePlace, Math.Max(a.Y, b.Y) + SamePlace);
            for (int column = fromColumn; column <= toColumn; column++)
            {
                for (int row = fromRow; row <= toRow; row++)
                {
                    (_cells.TryGetValue((column, row), out List<int>? cell) ? cell : _cells[(column, row)] = []).Add(i);
                }
            }
        }
    }

    /// <summary>Number of links of the first network.</summary>
    public int Links { get; private set; }

    /// <summary>Number of these that match a link of the second.</summary>
    public int Matched { get; private set; }

    /// <summary>Number of matched links with the same lanes in both directions.</summary>
    public int SameLanes { get; private set; }

    /// <summary>Number of matched links that are one-way in both networks.</summary>
    public int OneWayInBoth { get; private set; }

    /// <summary>Number of these with the same direction in both networks.</summary>
    public int SameWay { get; private set; }

    /// <summary>Number of these with opposite directions.</summary>
    public int OppositeWays => OneWayInBoth - SameWay;

    /// <summary>Number of matched links that are one-way in only one network.</summary>
    public int OneWayInOne { get; private set; }

    /// <summary>Compares the links of two networks.</summary>
    public static NetworkComparison Of(RoadNetwork network, RoadNetwork other)
    {
        ArgumentNullException.ThrowIfNull(network);
        ArgumentNullException.ThrowIfNull(other);
        var comparison = new NetworkComparison(other) { Links = network.Links.Count };
        foreach (RoadLink link in network.Links)
        {
            (Vector3D a, Vector3D b) = Ends(network, link);
            if (comparison.Along(a, b) is { } there)
            {
                comparison.Count(link, there);
            }
        }

        return comparison;
    }

    private void Count(RoadLink link, RoadLink there)
    {
        Matched++;
        SameLanes += link.LanesForward == there.LanesForward && link.LanesBackward == there.LanesBackward ? 1 : 0;
        bool isOneWayInBoth = link.IsOneWay && there.IsOneWay;
        OneWayInBoth += isOneWayInBoth ? 1 : 0;
        SameWay += isOneWayInBoth && link.LanesForward > 0 == there.LanesForward > 0 ? 1 : 0;
        OneWayInOne += link.IsOneWay != there.IsOneWay ? 1 : 0;
    }

    /// <summary>The nearest link that the segment between two points matches; null if there is none.</summary>
    private RoadLink? Along(Vector3D from, Vector3D to)
    {
        Vector3D middle = (from + to) * 0.5;
        RoadLink? found = null;
        double nearest = SamePlace;
        foreach (int candidate in _cells.GetValueOrDefault(Cell(middle.X, middle.Y)) ?? [])
        {
            RoadLink link = _network.Links[candidate];
            (Vector3D a, Vector3D b) = Ends(_network, link);
            double along = (to - from).Dot(b - a) / ((to - from).Length * (b - a).Length);
            double distance = Distance(middle, a, b);
            if (Math.Abs(along) >= MinAlong && distance <= nearest)
            {
                nearest = distance;
                found = along > 0 ? link : link.Reversed();
            }
        }

        return found;
    }

    private static double Distance(Vector3D place, Vector3D a, Vector3D b)
    {
        Vector3D line = b - a;
        double share = Math.Clamp((place - a).Dot(line) / line.LengthSquared, 0, 1);
        return (place - (a + (line * share))).Length;
    }

    private static (Vector3D A, Vector3D B) Ends(RoadNetwork network, RoadLink link) =>
        (network.Nodes[link.From].Position, network.Nodes[link.To].Position);

    private static (int Column, int Row) Cell(double x, double y) => ((int)Math.Floor(x / CellMetres), (int)Math.Floor(y / CellMetres));
}
