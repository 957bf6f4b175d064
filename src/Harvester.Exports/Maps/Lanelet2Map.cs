using System.Globalization;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as Lanelet2's OpenStreetMap file: a lanelet for each lane, whose borders it shares with the lanes beside it and whose
/// end nodes it shares with those that follow, and the rules of lights and signs. Latitude and longitude are those of Lanelet2's default
/// projector about latitude 0 and longitude 0.
/// </summary>
public sealed class Lanelet2Map
{
    /// <summary>Single lines of at least this width are thick, metres.</summary>
    private const double ThickLine = 0.25;

    /// <summary>How far the middle of a lane may leave that of the map, metres.</summary>
    private const double MiddleTolerance = 0.01;

    private const string WayMember = "way";
    private const string RelationMember = "relation";
    private const double KmhPerMetresPerSecond = 3.6;

    private readonly LaneNetwork _map;
    private readonly LaneBorders _borders;
    private readonly MapLane[] _lanes;
    private readonly Lanelet2Signals _signals;
    private readonly Dictionary<LaneBorder, Lanelet2Way> _borderWays = [];
    private readonly Dictionary<MapLane, Lanelet2Way> _middles = [];
    private readonly List<(MapCrossing Crossing, Lanelet2Way Left, Lanelet2Way Right)> _crossings = [];
    private readonly OsmXml _xml;
    private readonly Dictionary<Lanelet2Way, long> _ways = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<MapLane, long> _lanelets = [];

    private Lanelet2Map(LaneNetwork map, OsmXml xml)
    {
        (_map, _xml) = (map, xml);
        _borders = new LaneBorders(map);
        _lanes = [.. map.Lanes.Where(lane => !_borders.LeftOut.Contains(lane))];
        _signals = new Lanelet2Signals(map, _borders);
        Lanelet2Sides.Settle(_borders, _lanes);
        foreach (LaneBorder border in _borders.Borders)
        {
            _borderWays.Add(border, new Lanelet2Way(border.Nodes, [.. TagsOf(border)]));
        }

        foreach (MapLane lane in _lanes.Where(lane => lane.Turn is MapTurn.Left or MapTurn.Right || _borders.HasOwnMiddle(lane)))
        {
            _middles.Add(
                lane,
                new Lanelet2Way(
                    [.. ThinnedLine.Of(_borders.MiddleOf(lane), MiddleTolerance).Select(_borders.AddNode)],
                    [("type", "virtual")]
                )
            );
        }

        foreach (MapCrossing crossing in map.Crossings.Where(crossing => crossing.Corners.Count == 4))
        {
            AddCrossing(crossing);
        }
    }

    /// <summary>Writes a map.</summary>
    /// <param name="map">The map.</param>
    /// <param name="stream">Receives the file, UTF-8.</param>
    public static void Write(LaneNetwork map, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(map);
        using var xml = new OsmXml(stream);
        new Lanelet2Map(map, xml).Write();
    }

    private void Write()
    {
        long[] nodes = [.. _borders.Nodes.Select(_xml.Node)];
        IEnumerable<Lanelet2Way> crossings = _crossings.SelectMany(crossing => new[] { crossing.Left, crossing.Right });
        foreach (Lanelet2Way way in _borderWays.Values.Concat(_middles.Values).Concat(_signals.Ways).Concat(crossings))
        {
            _ways.Add(way, _xml.Way(way.Nodes.Select(node => nodes[node]), way.Tags));
        }

        foreach (MapLane lane in _lanes)
        {
            _lanelets.Add(lane, _xml.NextId());
        }

        ILookup<MapLane, long> rules = WriteRules();
        foreach (MapLane lane in _lanes)
        {
            WriteLane(lane, rules[lane]);
        }

        foreach ((MapCrossing crossing, Lanelet2Way left, Lanelet2Way right) in _crossings)
        {
            _xml.Relation(
                _xml.NextId(),
                [(WayMember, _ways[left], "left"), (WayMember, _ways[right], "right")],
                ("type", "lanelet"),
                ("subtype", "crosswalk"),
                ("location", "urban"),
                ("one_way", "no"),
                ("participant:pedestrian", "yes"),
                ("name", crossing.Id)
            );
        }

        _xml.End();
    }

    private ILookup<MapLane, long> WriteRules()
    {
        var rules = new List<(MapLane Lane, long Rule)>();
        foreach (Lanelet2Rule rule in _signals.Rules)
        {
            long id = _xml.NextId();
            _xml.Relation(
                id,
                rule.Ways.Select(member => (WayMember, _ways[member.Way], member.Role))
                    .Concat(rule.Lanes.Select(member => (RelationMember, _lanelets[member.Lane], member.Role))),
                ("type", "regulatory_element"),
                ("subtype", rule.Subtype)
            );
            rules.AddRange(rule.Governed.Select(lane => (lane, id)));
        }

        return rules.ToLookup(rule => rule.Lane, rule => rule.Rule);
    }

    private void WriteLane(MapLane lane, IEnumerable<long> rules)
    {
        List<(string, long, string)> members =
        [
            (WayMember, WayOf(_borders.LeftOf(lane)), "left"),
            (WayMember, WayOf(_borders.RightOf(lane)), "right"),
        ];
        if (_middles.TryGetValue(lane, out Lanelet2Way? middle))
        {
            members.Add((WayMember, _ways[middle], "centerline"));
        }

        members.AddRange(rules.Select(rule => (RelationMember, rule, "regulatory_element")));
        _xml.Relation(_lanelets[lane], members, TagsOf(lane));
    }

    private long WayOf(BorderSide side) => _ways[_borderWays[side.Border]];

    /// <summary>
    /// Where nothing is known to be painted, a border is virtual. It may be crossed if it lies between two lanes of one direction, because
    /// nothing is known to forbid it.
    /// </summary>
    private static IEnumerable<(string, string)> TagsOf(LaneBorder border)
    {
        if (border.Marking is not { Paint: var paint })
        {
            yield return ("type", "virtual");
            if (border.Kind == LaneBorderKind.Divider)
            {
                yield return ("lane_change", "yes");
            }

            yield break;
        }

        bool isThick = paint.Style != MarkingStyle.DoubleSolid && paint.WidthMetres >= ThickLine;
        yield return ("type", isThick ? "line_thick" : "line_thin");
        yield return (
            "subtype",
            paint.Style switch
            {
                MarkingStyle.Dashed => "dashed",
                MarkingStyle.DoubleSolid => "solid_solid",
                _ => "solid",
            }
        );
        yield return ("color", JsonName.Of(paint.Colour));
    }

    private IEnumerable<(string, string)> TagsOf(MapLane lane)
    {
        RoadLink link = _map.Network.Links[(lane.Link ?? lane.Predecessors[0].Link)!.Value];
        RoadNodeFlags flags = _map.Network.Nodes[link.From].Flags;
        bool isHighway = (flags & RoadNodeFlags.Highway) != 0;
        yield return ("type", "lanelet");
        yield return ("subtype", isHighway ? "highway" : "road");
        yield return ("location", isHighway || (flags & RoadNodeFlags.OffRoad) != 0 ? "nonurban" : "urban");
        yield return ("one_way", "yes");
        yield return ("participant:vehicle", "yes");
        yield return ("name", lane.Id);
        if (lane.SpeedLimit is { } limit)
        {
            yield return ("speed_limit", (limit * KmhPerMetresPerSecond).ToString("0.#", CultureInfo.InvariantCulture) + " km/h");
        }

        if (lane.Turn is { } turn)
        {
            yield return ("turn_direction", JsonName.Of(turn));
        }
    }

    /// <summary>People walk along the longer sides of a crossing.</summary>
    private void AddCrossing(MapCrossing crossing)
    {
        int[] corners = [.. crossing.Corners.Select(_borders.AddNode)];
        double SideOf(int corner) => (crossing.Corners[(corner + 1) % 4] - crossing.Corners[corner]).Length;
        int first = SideOf(0) + SideOf(2) >= SideOf(1) + SideOf(3) ? 0 : 1;
        (string, string)[] tags = [("type", crossing.Source == MapSource.Derived ? "virtual" : "pedestrian_marking")];
        _crossings.Add(
            (
                crossing,
                new Lanelet2Way([corners[(first + 3) % 4], corners[first + 2]], tags),
                new Lanelet2Way([corners[first], corners[first + 1]], tags)
            )
        );
    }
}
