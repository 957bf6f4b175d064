using System.Xml.Linq;
using Harvester.Exports.Maps;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Tests.Maps;

/// <summary>The Lanelet2 file of a town, read by a reader of its own and compared with the lane map.</summary>
public sealed class Lanelet2MapTests
{
    /// <summary>What is allowed between the file's lanes and the map's, metres.</summary>
    private const double MaxDeviation = 0.05;

    /// <summary>Rounding of the local coordinates, which have four decimals, metres.</summary>
    private const double Rounding = 0.0001;

    private static readonly LaneNetwork Map = TownMap.Of(471);
    private static readonly Lanelet2File File = new(Text(Map));
    private static readonly Dictionary<string, Lanelet2Lane> Lanes = File.Lanelets.ToDictionary(lane => lane.Name, StringComparer.Ordinal);

    [Fact]
    public void Ids_differ_and_references_resolve()
    {
        Assert.Equal(File.Elements.Count, File.Elements.Select(Lanelet2File.Id).Distinct().Count());
        Assert.All(File.Ways.Values.SelectMany(way => way.Elements("nd")), node => Assert.Contains(Lanelet2File.Ref(node), File.Nodes));
        Assert.All(
            File.Relations.Values.SelectMany(relation => relation.Elements("member")),
            member =>
                Assert.True(
                    member.Attribute("type")!.Value == "way"
                        ? File.Ways.ContainsKey(Lanelet2File.Ref(member))
                        : File.Relations.ContainsKey(Lanelet2File.Ref(member))
                )
        );
    }

    [Fact]
    public void Every_lane_is_a_lanelet_and_every_crossing()
    {
        Assert.Equal(
            Map.Lanes.Select(lane => lane.Id).Concat(Map.Crossings.Select(crossing => crossing.Id)).Order(StringComparer.Ordinal),
            Lanes.Keys.Order(StringComparer.Ordinal)
        );
        Assert.Equal("crosswalk", Lanelet2File.Tag(Lanes[Map.Crossings[0].Id].Relation, "subtype"));
    }

    [Fact]
    public void Projected_nodes_lie_where_their_local_tags_say()
    {
        foreach ((long id, XElement node) in File.Nodes)
        {
            (double x, double y) = File.Place(id);
            Assert.Equal(Lanelet2File.Number(Lanelet2File.Tag(node, "local_x")!), x, Rounding);
            Assert.Equal(Lanelet2File.Number(Lanelet2File.Tag(node, "local_y")!), y, Rounding);
        }
    }

    [Fact]
    public void Lanes_beside_each_other_share_their_border()
    {
        foreach (MapLane lane in Map.Lanes)
        {
            if (lane.RightNeighbour is { } right)
            {
                Assert.Equal(Lanes[lane.Id].RightWay, Lanes[right.Id].LeftWay);
            }

            if (lane.Oncoming is { } oncoming && (lane.Left[0] - oncoming.Left[^1]).Length < Rounding)
            {
                Assert.Equal(Lanes[lane.Id].LeftWay, Lanes[oncoming.Id].LeftWay);
            }
        }
    }

    [Fact]
    public void Lanes_that_follow_each_other_share_their_end_nodes()
    {
        ILookup<(long, long), string> starts = Lanes.Values.ToLookup(lane => (lane.Left[0], lane.Right[0]), lane => lane.Name);
        foreach (MapLane lane in Map.Lanes)
        {
            Lanelet2Lane written = Lanes[lane.Id];

            Assert.Equal(
                lane.Successors.Select(next => next.Id).Order(StringComparer.Ordinal),
                starts[(written.Left[^1], written.Right[^1])].Order(StringComparer.Ordinal)
            );
        }
    }

    [Fact]
    public void Middles_lie_where_the_map_has_them() =>
        Assert.All(
            Map.Lanes,
            lane =>
                Assert.All(
                    Lanes[lane.Id].Middle(),
                    point => Assert.InRange(TownMap.DistanceFrom(lane.Centre, point.X, point.Y), 0, MaxDeviation)
                )
        );

    [Fact]
    public void Known_paint_gives_the_type_of_a_border_and_none_is_virtual()
    {
        foreach (MapLane lane in Map.Lanes.Where(lane => lane.RightNeighbour is not null))
        {
            XElement way = File.Ways[Lanes[lane.Id].RightWay];

            Assert.Equal(lane.RightMarking is null ? "virtual" : "line_thin", Lanelet2File.Tag(way, "type"));
            Assert.Equal(lane.RightMarking is null ? null : "dashed", Lanelet2File.Tag(way, "subtype"));
            Assert.Equal(lane.RightMarking is null ? "yes" : null, Lanelet2File.Tag(way, "lane_change"));
        }

        Assert.Contains(Map.Lanes, lane => lane.RightMarking is not null);
    }

    [Fact]
    public void Lights_are_rules_of_the_lanes_that_they_govern()
    {
        XElement[] rules = [.. File.Rules.Where(rule => Lanelet2File.Tag(rule, "subtype") == "traffic_light")];
        MapSignal[] lights = [.. Map.Signals.Where(signal => signal.Kind == MapSignalKind.Light)];

        Assert.Equal(lights.Length, rules.Sum(rule => Lanelet2File.Members(rule, "refers").Length));
        foreach (XElement rule in rules)
        {
            Assert.All(
                Lanelet2File.Members(rule, "refers"),
                way => Assert.Equal("traffic_light", Lanelet2File.Tag(File.Ways[way], "type"))
            );
            Assert.Single(Lanelet2File.Members(rule, "ref_line"));
            string[] governed = GovernedBy(rule);
            Assert.Contains(lights, light => light.Lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal).SequenceEqual(governed));
        }
    }

    [Fact]
    public void Lanes_with_a_stop_sign_yield_to_those_without()
    {
        XElement rule = Assert.Single(File.Rules, rule => Lanelet2File.Tag(rule, "subtype") == "right_of_way");
        string[] yielding = NamesOf(rule, "yield");
        MapLane[] signed = [.. yielding.Select(name => Map.Find(name)!)];
        int junction = signed[0].Successors[0].Junction!.Value;

        Assert.All(signed, lane => Assert.Equal(MapSignalKind.StopSign, Assert.Single(lane.Signals).Kind));
        Assert.Equal(
            Map.Lanes.Where(lane => lane.Successors is [{ Junction: var at }, ..] && at == junction && lane.Signals.Count == 0)
                .Select(lane => lane.Id)
                .Order(StringComparer.Ordinal),
            NamesOf(rule, "right_of_way")
        );
        Assert.Single(Lanelet2File.Members(rule, "ref_line"));
    }

    [Fact]
    public void Junction_with_stop_signs_all_round_is_an_all_way_stop()
    {
        XElement rule = Assert.Single(File.Rules, rule => Lanelet2File.Tag(rule, "subtype") == "all_way_stop");

        Assert.Equal(NamesOf(rule, "yield"), GovernedBy(rule));
        Assert.Equal(Lanelet2File.Members(rule, "yield").Length, Lanelet2File.Members(rule, "ref_line").Length);
    }

    private static string[] NamesOf(XElement rule, string role) =>
        [.. Lanelet2File.Members(rule, role).Select(id => Lanelet2File.Tag(File.Relations[id], "name")!).Order(StringComparer.Ordinal)];

    private static string[] GovernedBy(XElement rule) =>
        [
            .. Lanes
                .Values.Where(lane => Lanelet2File.Members(lane.Relation, "regulatory_element").Contains(Lanelet2File.Id(rule)))
                .Select(lane => lane.Name)
                .Order(StringComparer.Ordinal),
        ];

    private static string Text(LaneNetwork map)
    {
        using var stream = new MemoryStream();
        Lanelet2Map.Write(map, stream);
        return System.Text.Encoding.UTF8.GetString(stream.ToArray());
    }
}
