using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Roads;

namespace Harvester.TestSupport;

/// <summary>
/// A game's answers about a known network: truncated positions, the southern end of a link first, nodes loaded after some ticks.
/// </summary>
internal sealed class FakeRoadSource(RoadNetwork network, int ticksUntilLoaded = 0) : IRoadSource
{
    private int _ticks;

    public int Calls { get; private set; }

    /// <summary>How wide this game's lanes are, metres.</summary>
    public double LaneWidth { get; init; } = 5.4;

    /// <summary>The edge that the game reports: by default the right one, looking away from the node.</summary>
    public Func<RoadSides, Vector3D?> ReportedEdge { get; init; } = sides => sides.OnTheRight;

    public bool RequestNodes(Vector3D centre, double range) => _ticks++ >= ticksUntilLoaded;

    public SurveyedNode? NthClosestNode(Vector3D place, int number)
    {
        Calls++;
        RoadNode? node = network.Nodes.OrderBy(node => (Stored(node) - place).LengthSquared).Skip(number - 1).FirstOrDefault();
        return node is null ? null : new SurveyedNode((node.Number << 16) + node.Area + 1, Stored(node));
    }

    public SurveyedProperties? ReadProperties(Vector3D place)
    {
        Calls++;
        RoadNode node = network.Nodes.MinBy(node => (Stored(node) - place).LengthSquared)!;
        // The game's own bits: 64 highway, 128 junction, 8 switched off.
        return new SurveyedProperties(
            node.Density ?? 0,
            (node.Flags.HasFlag(RoadNodeFlags.Highway) ? 64 : 0)
                + (node.Flags.HasFlag(RoadNodeFlags.Junction) ? 128 : 0)
                + (node.Flags.HasFlag(RoadNodeFlags.SwitchedOff) ? 8 : 0)
        );
    }

    public SurveyedRoad? ClosestRoad(Vector3D place)
    {
        Calls++;
        RoadLink link = network.Links.MinBy(link => Distance(place, Stored(network.Nodes[link.From]), Stored(network.Nodes[link.To])))!;
        RoadLink northwards = Stored(network.Nodes[link.From]).Y <= Stored(network.Nodes[link.To]).Y ? link : link.Reversed();
        return new SurveyedRoad(
            Stored(network.Nodes[northwards.From]),
            Stored(network.Nodes[northwards.To]),
            northwards.LanesBackward,
            northwards.LanesForward,
            northwards.MedianWidth ?? -1
        );
    }

    public Vector3D? RoadEdge(Vector3D node, double headingDegrees)
    {
        Calls++;
        double heading = headingDegrees * Math.PI / 180;
        var asked = new Vector3D(-Math.Sin(heading), Math.Cos(heading), 0);
        int nearest = Enumerable.Range(0, network.Nodes.Count).MinBy(i => (Stored(network.Nodes[i]) - node).LengthSquared);
        RoadLink leaving = network
            .LinksOf(nearest)
            .Select(link => network.Links[link].From == nearest ? network.Links[link] : network.Links[link].Reversed())
            .MaxBy(link => Along(link).Dot(asked))!;
        double median = leaving.MedianWidth ?? 0;
        double whole = LaneWidth * (leaving.LanesForward + leaving.LanesBackward);
        Vector3D along = Along(leaving);
        return ReportedEdge(
            new RoadSides(
                Stored(network.Nodes[nearest]),
                new Vector3D(along.Y, -along.X, 0),
                leaving.IsOneWay ? whole / 2 : (median / 2) + (leaving.LanesForward * LaneWidth),
                leaving.IsOneWay ? whole / 2 : (median / 2) + (leaving.LanesBackward * LaneWidth)
            )
        );
    }

    private Vector3D Along(RoadLink link)
    {
        Vector3D chord = Stored(network.Nodes[link.To]) - Stored(network.Nodes[link.From]);
        return new Vector3D(chord.X, chord.Y, 0) * (1 / Math.Sqrt((chord.X * chord.X) + (chord.Y * chord.Y)));
    }

    private static Vector3D Stored(RoadNode node) => PathGrid.Truncate(node.Position);

    private static double Distance(Vector3D place, Vector3D a, Vector3D b)
    {
        Vector3D along = b - a;
        double part = Math.Clamp((place - a).Dot(along) / along.LengthSquared, 0, 1);
        return (a + (along * part) - place).Length;
    }
}
