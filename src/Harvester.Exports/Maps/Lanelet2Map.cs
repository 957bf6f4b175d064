using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as Lanelet2's OpenStreetMap file: a lanelet for each lane, whose borders it shares with the lanes beside it and whose
/// end nodes it shares with those that follow.
/// </summary>
public sealed class Lanelet2Map
{
    private readonly LaneNetwork _map;
    private readonly LaneBorders _borders;
    private readonly OsmXml _xml;
    private readonly Dictionary<LaneBorder, long> _ways = [];
    private readonly Dictionary<MapLane, long> _lanelets = [];

    private Lanelet2Map(LaneNetwork map, OsmXml xml)
    {
        (_map, _xml) = (map, xml);
        _borders = new LaneBorders(map);
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
        foreach (LaneBorder border in _borders.Borders)
        {
            _ways.Add(border, _xml.Way(border.Nodes.Select(node => nodes[node]), TagsOf(border)));
        }

        foreach (MapLane lane in _map.Lanes)
        {
            _lanelets.Add(lane, _xml.NextId());
        }

        foreach (MapLane lane in _map.Lanes)
        {
            _xml.Relation(
                _lanelets[lane],
                [("way", _ways[_borders.LeftOf(lane).Border], "left"), ("way", _ways[_borders.RightOf(lane).Border], "right")],
                TagsOf(lane)
            );
        }
    }

    /// <summary>What is painted is unknown, so a border is virtual. Traffic may cross it only between lanes of one direction.</summary>
    private static IEnumerable<(string, string)> TagsOf(LaneBorder border)
    {
        yield return ("type", "virtual");
        if (border.Kind == LaneBorderKind.Divider)
        {
            yield return ("lane_change", "yes");
        }
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
        if (lane.Turn is { } turn)
        {
            yield return ("turn_direction", JsonName.Of(turn));
        }
    }
}
