using System.Xml.Linq;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Simulation.World;

namespace Harvester.Exports.Tests.Maps;

/// <summary>The OpenDRIVE file of a town, read by a reader of its own and compared with the lane map.</summary>
public sealed class OpenDriveMapTests
{
    /// <summary>What is allowed between the file's lanes and the map's, metres.</summary>
    private const double MaxDeviation = 0.05;

    /// <summary>What it allows between lanes that follow each other, metres.</summary>
    private const double MaxGap = 0.01;

    private static readonly LaneNetwork Map = MapOf(471);
    private static readonly XElement File = Read(Map);
    private static readonly OpenDriveLane[] Lanes =
    [
        .. File.Elements("road")
            .SelectMany(road =>
                road.Descendants("lane")
                    .Where(lane => lane.Attribute("type")!.Value == "driving")
                    .Select(lane => new OpenDriveLane(road, lane))
            ),
    ];

    [Fact]
    public void Every_lane_is_there_once()
    {
        Assert.Equal(
            Map.Lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal),
            Lanes.Select(lane => lane.Name).Order(StringComparer.Ordinal)
        );
        string[] ids = [.. File.Elements("road").Concat(File.Elements("junction")).Select(part => part.Attribute("id")!.Value)];
        Assert.Equal(ids.Length, ids.Distinct().Count());
    }

    [Fact]
    public void Lanes_lie_where_the_map_has_them()
    {
        foreach (OpenDriveLane lane in Lanes)
        {
            MapLane wanted = Map.Find(lane.Name)!;
            for (double fraction = 0; fraction <= 1; fraction += 0.25)
            {
                Assert.InRange(DistanceFrom(wanted.Centre, lane.MiddleAt(fraction)), 0, MaxDeviation);
            }
        }
    }

    [Fact]
    public void Lanes_lead_where_the_map_says_without_a_gap()
    {
        Dictionary<(string, int), OpenDriveLane> byId = Lanes.ToDictionary(lane => (lane.RoadId, lane.Id));
        ILookup<string, XElement> connections = File.Descendants("connection")
            .ToLookup(connection => connection.Attribute("incomingRoad")!.Value);
        foreach (OpenDriveLane lane in Lanes)
        {
            OpenDriveLane[] next = [.. lane.Next(connections).Select(id => byId[id])];

            Assert.Equal(
                Map.Find(lane.Name)!.Successors.Select(successor => successor.Id).Order(StringComparer.Ordinal),
                next.Select(successor => successor.Name).Order(StringComparer.Ordinal)
            );
            Assert.All(next, successor => Assert.InRange((EndOf(lane) - StartOf(successor)).Length, 0, MaxGap));
        }
    }

    [Fact]
    public void Street_names_that_xml_does_not_allow_are_written()
    {
        var network = new RoadNetwork(
            [
                new RoadNode(1, 0, new Vector3D(0, 0, 0), "A\u0001\ud800B", RoadNodeFlags.None),
                new RoadNode(1, 1, new Vector3D(50, 0, 0), string.Empty, RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, 1, 1, null, RoadLinkFlags.None)]
        );

        XElement file = Read(LaneNetwork.Of(new RoadCurves(network), new LaneModel(network)));

        Assert.Equal("A\ufffd\ufffdB", file.Element("road")!.Attribute("name")!.Value);
    }

    [Fact]
    public void Same_roads_give_the_same_bytes() => Assert.Equal(Text(Map), Text(MapOf(471)));

    private static Vector3D StartOf(OpenDriveLane lane) => lane.MiddleAt(lane.Id < 0 ? 0 : 1);

    private static Vector3D EndOf(OpenDriveLane lane) => lane.MiddleAt(lane.Id < 0 ? 1 : 0);

    private static LaneNetwork MapOf(int seed)
    {
        RoadNetwork network = TownBuilder.Build(seed);
        return LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));
    }

    private static XElement Read(LaneNetwork map) => XDocument.Parse(Text(map)).Root!;

    private static string Text(LaneNetwork map)
    {
        using var stream = new MemoryStream();
        OpenDriveMap.Write(map, "town", stream);
        return System.Text.Encoding.UTF8.GetString(stream.ToArray());
    }

    private static double DistanceFrom(IReadOnlyList<Vector3D> line, Vector3D point)
    {
        double best = double.PositiveInfinity;
        for (int i = 1; i < line.Count; i++)
        {
            Vector3D piece = line[i] - line[i - 1];
            Vector3D to = point - line[i - 1];
            double t = Math.Clamp(piece.Dot(to) / Math.Max(piece.Dot(piece), double.Epsilon), 0, 1);
            best = Math.Min(best, (to - (piece * t)).Length);
        }

        return best;
    }
}
