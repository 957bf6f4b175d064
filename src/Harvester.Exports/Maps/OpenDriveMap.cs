using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;

namespace Harvester.Exports.Maps;

/// <summary>
/// Writes a lane map as ASAM OpenDRIVE 1.7: a road for each part of a link outside junctions and for each way through a junction. Metres,
/// x east, y north, z up, as in the game's world.
/// </summary>
public sealed class OpenDriveMap
{
    private const string NoJunction = "-1";
    private readonly LaneNetwork _map;
    private readonly Dictionary<int, OpenDriveRoad> _roadOfLink = [];
    private readonly Dictionary<MapLane, int> _laneIds = [];
    private readonly Dictionary<MapLane, int> _ways = [];
    private readonly OpenDriveXml _xml;
    private readonly OpenDriveFurniture _furniture;

    private OpenDriveMap(LaneNetwork map, OpenDriveXml xml)
    {
        (_map, _xml) = (map, xml);
        foreach (RoadSegment segment in map.Segments)
        {
            var road = new OpenDriveRoad(_roadOfLink.Count + 1, segment);
            _roadOfLink.Add(segment.Link, road);
            foreach ((MapLane lane, int id) in road.LaneIds)
            {
                _laneIds.Add(lane, id);
            }
        }

        foreach (MapLane way in map.Junctions.SelectMany(junction => junction.Ways))
        {
            _ways.Add(way, _roadOfLink.Count + _ways.Count + 1);
        }

        _furniture = new OpenDriveFurniture(map, _laneIds, _roadOfLink.Count + _ways.Count + map.Junctions.Count + 1, xml);
    }

    /// <summary>Writes a map.</summary>
    /// <param name="map">The map; it has at least one road.</param>
    /// <param name="name">A name for the header.</param>
    /// <param name="stream">Receives the file, UTF-8.</param>
    public static void Write(LaneNetwork map, string name, Stream stream)
    {
        ArgumentNullException.ThrowIfNull(map);
        using var xml = new OpenDriveXml(stream);
        new OpenDriveMap(map, xml).Write(name);
    }

    private void Write(string name)
    {
        _xml.Begin("OpenDRIVE");
        Vector3D[] points = [.. _map.Lanes.SelectMany(lane => lane.Centre)];
        _xml.Element(
            "header",
            ("revMajor", "1"),
            ("revMinor", "7"),
            ("name", name),
            ("north", OpenDriveXml.Text(points.Max(point => point.Y))),
            ("south", OpenDriveXml.Text(points.Min(point => point.Y))),
            ("east", OpenDriveXml.Text(points.Max(point => point.X))),
            ("west", OpenDriveXml.Text(points.Min(point => point.X))),
            ("vendor", "GtaDataHarvester")
        );
        foreach (RoadSegment segment in _map.Segments)
        {
            WriteRoad(_roadOfLink[segment.Link]);
        }

        foreach (MapLane way in _ways.Keys)
        {
            WriteWay(way);
        }

        _furniture.WriteControllers();
        for (int i = 0; i < _map.Junctions.Count; i++)
        {
            WriteJunction(_map.Junctions[i], i);
        }

        _xml.End();
    }

    private string JunctionId(int junction) => OpenDriveXml.Text(_roadOfLink.Count + _ways.Count + junction + 1);

    private void WriteRoad(OpenDriveRoad road)
    {
        RoadSegment segment = road.Segment;
        RoadLink link = _map.Network.Links[segment.Link];
        RoadNode node = _map.Network.Nodes[link.From];
        _xml.Begin(
            "road",
            ("name", node.Street),
            ("length", OpenDriveXml.Text(road.Length)),
            ("id", OpenDriveXml.Text(road.Id)),
            ("junction", NoJunction),
            ("rule", "RHT")
        );
        _xml.Begin("link");
        WriteEnd("predecessor", segment.Start);
        WriteEnd("successor", segment.End);
        _xml.End();
        _xml.Element("type", ("s", "0"), ("type", TypeOf(node.Flags)));
        OpenDriveShape.Write(_xml, segment.Line, road.Length);
        _xml.Begin("lanes");
        foreach (OpenDrivePiece piece in road.LaneOffset)
        {
            _xml.Polynomial("laneOffset", piece.Station, piece.Value, piece.Slope);
        }

        _xml.Begin("laneSection", ("s", "0"));
        WriteSide("left", segment.Backward.Reverse(), isForward: false, road, road.GapWidth);
        WriteCentre((segment.Forward.Count > 0 ? segment.Forward[0] : segment.Backward[0]).LeftMarking);
        WriteSide("right", segment.Forward, isForward: true, road, gap: []);
        _xml.End();
        _xml.End();
        _furniture.WriteOn(road);
        _xml.End();
    }

    private void WriteSide(string side, IEnumerable<MapLane> lanes, bool isForward, OpenDriveRoad road, IReadOnlyList<OpenDrivePiece> gap)
    {
        MapLane[] all = [.. lanes];
        if (all.Length == 0)
        {
            return;
        }

        _xml.Begin(side);
        foreach (MapLane lane in all)
        {
            // Before and after follow the road's line, which backward lanes are driven against.
            MapLane? behind = lane.Predecessors.FirstOrDefault(other => other.Junction is null);
            MapLane? ahead = lane.Successors.FirstOrDefault(other => other.Junction is null);
            (MapLane? before, MapLane? after) = isForward ? (behind, ahead) : (ahead, behind);
            WriteLane(_laneIds[lane], "driving", IdOf(before), IdOf(after), road.WidthOf(lane), lane, lane.RightMarking);
        }

        if (gap.Count > 0)
        {
            WriteLane(1, "median", null, null, gap, null, all[^1].LeftMarking);
        }

        _xml.End();
    }

    private int? IdOf(MapLane? lane) => lane is null ? null : _laneIds[lane];

    private void WriteCentre(MapMarking? marking)
    {
        _xml.Begin("center");
        _xml.Begin("lane", ("id", "0"), ("type", "none"), ("level", "false"));
        OpenDriveMark.Write(_xml, marking);
        _xml.End();
        _xml.End();
    }

    private void WriteLane(
        int id,
        string type,
        int? before,
        int? after,
        IReadOnlyList<OpenDrivePiece> width,
        MapLane? lane,
        MapMarking? marking
    )
    {
        _xml.Begin("lane", ("id", OpenDriveXml.Text(id)), ("type", type), ("level", "false"));
        if (before is not null || after is not null)
        {
            _xml.Begin("link");
            if (before is { } first)
            {
                _xml.Element("predecessor", ("id", OpenDriveXml.Text(first)));
            }

            if (after is { } last)
            {
                _xml.Element("successor", ("id", OpenDriveXml.Text(last)));
            }

            _xml.End();
        }

        foreach (OpenDrivePiece piece in width)
        {
            _xml.Polynomial("width", piece.Station, piece.Value, piece.Slope, "sOffset");
        }

        OpenDriveMark.Write(_xml, marking);
        if (lane?.SpeedLimit is { } limit)
        {
            _xml.Element("speed", ("sOffset", "0"), ("max", OpenDriveXml.Text(limit)), ("unit", "m/s"));
        }

        if (lane is not null)
        {
            _xml.Element("userData", ("code", "laneId"), ("value", lane.Id));
        }

        _xml.End();
    }

    private void WriteWay(MapLane way)
    {
        HermiteCurve curve = way.Line!.Value;
        double length = curve.Length;
        (MapLane from, MapLane to) = (way.Predecessors[0], way.Successors[0]);
        _xml.Begin(
            "road",
            ("name", ""),
            ("length", OpenDriveXml.Text(length)),
            ("id", OpenDriveXml.Text(_ways[way])),
            ("junction", JunctionId(way.Junction!.Value)),
            ("rule", "RHT")
        );
        _xml.Begin("link");
        WriteContact("predecessor", from, isAtItsEnd: true);
        WriteContact("successor", to, isAtItsEnd: false);
        _xml.End();
        OpenDriveShape.Write(_xml, curve, length);
        _xml.Begin("lanes");

        // The line is the middle of the lane: lane 0 lies half a width to its left.
        double slope = (way.EndWidth - way.StartWidth) / length;
        _xml.Polynomial("laneOffset", 0, way.StartWidth / 2, slope / 2);
        _xml.Begin("laneSection", ("s", "0"));
        WriteCentre(null);
        _xml.Begin("right");
        WriteLane(-1, "driving", _laneIds[from], _laneIds[to], [new OpenDrivePiece(0, way.StartWidth, slope)], way, null);
        _xml.End();
        _xml.End();
        _xml.End();
        _xml.End();
    }

    private void WriteJunction(MapJunction junction, int index)
    {
        if (junction.Ways.Count == 0)
        {
            return;
        }

        _xml.Begin("junction", ("id", JunctionId(index)), ("name", junction.Id));
        int connection = 0;
        foreach (MapLane way in junction.Ways)
        {
            MapLane from = way.Predecessors[0];
            _xml.Begin(
                "connection",
                ("id", OpenDriveXml.Text(connection++)),
                ("incomingRoad", OpenDriveXml.Text(_roadOfLink[from.Link!.Value].Id)),
                ("connectingRoad", OpenDriveXml.Text(_ways[way])),
                ("contactPoint", "start")
            );
            _xml.Element("laneLink", ("from", OpenDriveXml.Text(_laneIds[from])), ("to", "-1"));
            _xml.End();
        }

        _furniture.WriteControllersOf(index);
        _xml.End();
    }

    private void WriteEnd(string name, SegmentEnd end)
    {
        if (end.Junction is { } junction && _map.Junctions[junction].Ways.Count > 0)
        {
            _xml.Element(name, ("elementType", "junction"), ("elementId", JunctionId(junction)));
        }
        else if (end.Link is { } link && _roadOfLink.TryGetValue(link, out OpenDriveRoad? road))
        {
            _xml.Element(
                name,
                ("elementType", "road"),
                ("elementId", OpenDriveXml.Text(road.Id)),
                ("contactPoint", end.AtStartOfLink ? "start" : "end")
            );
        }
    }

    private void WriteContact(string name, MapLane lane, bool isAtItsEnd) =>
        _xml.Element(
            name,
            ("elementType", "road"),
            ("elementId", OpenDriveXml.Text(_roadOfLink[lane.Link!.Value].Id)),
            ("contactPoint", lane.IsForward == isAtItsEnd ? "end" : "start")
        );

    private static string TypeOf(RoadNodeFlags flags) =>
        (flags & RoadNodeFlags.Highway) != 0 ? "motorway"
        : (flags & RoadNodeFlags.OffRoad) != 0 ? "rural"
        : "town";
}
