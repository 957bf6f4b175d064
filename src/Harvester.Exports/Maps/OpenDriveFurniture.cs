using Harvester.Geometry;
using Harvester.Geometry.Maps;

namespace Harvester.Exports.Maps;

/// <summary>
/// Stop lines, crossings, lights and signs in OpenDRIVE's terms: stop lines and crossings are objects, lights and signs signals of the road
/// whose lanes they govern, and the lights of those lanes have a controller, which belongs to the junction.
/// </summary>
internal sealed class OpenDriveFurniture
{
    /// <summary>Signals farther beyond the end of their road have a position of their own, metres.</summary>
    private const double AtEnd = 0.01;

    /// <summary>Crossings farther than this from every road belong to none, metres.</summary>
    private const double MaxFromRoad = 40;

    private readonly OpenDriveXml _xml;
    private readonly IReadOnlyDictionary<MapLane, int> _laneIds;
    private readonly ILookup<int, (MapSignal Signal, int Id)> _signals;
    private readonly ILookup<int, (MapStopLine Line, int Id)> _stopLines;
    private readonly ILookup<int, (MapCrossing Crossing, int Id)> _crossings;
    private readonly Controller[] _controllers;
    private readonly ILookup<int, Controller> _controllersOf;

    /// <summary>Prepares the furniture of a map.</summary>
    /// <param name="map">The map.</param>
    /// <param name="laneIds">The ids of the lanes of roads.</param>
    /// <param name="firstId">The first id of controllers.</param>
    /// <param name="xml">Receives the elements.</param>
    public OpenDriveFurniture(LaneNetwork map, IReadOnlyDictionary<MapLane, int> laneIds, int firstId, OpenDriveXml xml)
    {
        (_xml, _laneIds) = (xml, laneIds);
        (MapSignal Signal, int Id)[] signals =
        [
            .. map.Signals.Where(signal => signal.Lanes.Count > 0).Select((signal, index) => (signal, index + 1)),
        ];
        _signals = signals.ToLookup(pair => pair.Signal.Lanes[0].Link!.Value);
        _stopLines = map.StopLines.Select((line, index) => (line, index + 1)).ToLookup(pair => pair.line.Lanes[0].Link!.Value);
        _crossings = map
            .Crossings.Select((crossing, index) => (Crossing: crossing, Id: map.StopLines.Count + index + 1, Link: LinkOf(map, crossing)))
            .Where(place => place.Link is not null)
            .ToLookup(place => place.Link!.Value, place => (place.Crossing, place.Id));
        _controllers =
        [
            .. signals
                .Where(pair => pair.Signal.Kind == MapSignalKind.Light)
                .GroupBy(pair => pair.Signal.Lanes[0])
                .Select(
                    (lights, index) => new Controller(firstId + index, JunctionOf(map, lights.Key), [.. lights.Select(light => light.Id)])
                ),
        ];
        _controllersOf = _controllers.ToLookup(controller => controller.Junction);
    }

    /// <summary>Writes the objects and signals of a road.</summary>
    public void WriteOn(OpenDriveRoad road)
    {
        int link = road.Segment.Link;
        if (_stopLines.Contains(link) || _crossings.Contains(link))
        {
            _xml.Begin("objects");
            foreach ((MapStopLine line, int id) in _stopLines[link])
            {
                WriteStopLine(road, line, id);
            }

            foreach ((MapCrossing crossing, int id) in _crossings[link])
            {
                BeginObject(road, id, "crosswalk", null, crossing.Id, "none", crossing.Corners, isClosed: true);
                _xml.End();
            }

            _xml.End();
        }

        if (_signals.Contains(link))
        {
            _xml.Begin("signals");
            foreach ((MapSignal signal, int id) in _signals[link])
            {
                WriteSignal(road, signal, id);
            }

            _xml.End();
        }
    }

    /// <summary>Writes the controllers of all lights.</summary>
    public void WriteControllers()
    {
        foreach (Controller controller in _controllers)
        {
            _xml.Begin("controller", ("id", OpenDriveXml.Text(controller.Id)));
            foreach (int light in controller.Lights)
            {
                _xml.Element("control", ("signalId", OpenDriveXml.Text(light)), ("type", "0"));
            }

            _xml.End();
        }
    }

    /// <summary>Writes the references of a junction to its controllers.</summary>
    public void WriteControllersOf(int junction)
    {
        foreach (Controller controller in _controllersOf[junction])
        {
            _xml.Element("controller", ("id", OpenDriveXml.Text(controller.Id)), ("type", "0"));
        }
    }

    private static int? LinkOf(LaneNetwork map, MapCrossing crossing)
    {
        Vector3D middle = crossing.Corners.Aggregate(static (sum, corner) => sum + corner) * (1.0 / crossing.Corners.Count);
        return map
            .Index.Near(middle, MaxFromRoad)
            .Where(lane => lane.Link is not null)
            .MinBy(lane => lane.Centre.Min(point => (point - middle).Length))
            ?.Link;
    }

    private static int JunctionOf(LaneNetwork map, MapLane lane) => lane.Successors.Count > 0 ? lane.Successors[0].Junction ?? -1 : -1;

    private void WriteStopLine(OpenDriveRoad road, MapStopLine line, int id)
    {
        BeginObject(
            road,
            id,
            "roadMark",
            "signalLines",
            line.Id,
            line.Lanes[0].IsForward ? "+" : "-",
            [line.Left, line.Right],
            isClosed: false
        );
        WriteValidity(line.Lanes);
        _xml.End();
    }

    private void BeginObject(
        OpenDriveRoad road,
        int id,
        string type,
        string? subtype,
        string name,
        string orientation,
        IReadOnlyList<Vector3D> corners,
        bool isClosed
    )
    {
        Vector3D middle = corners.Aggregate(static (sum, corner) => sum + corner) * (1.0 / corners.Count);
        OpenDrivePlace place = OpenDrivePlace.Of(road.Segment.Line, road.Length, middle);
        _xml.Begin(
            "object",
            [
                ("type", type),
                .. subtype is null ? Array.Empty<(string, string)>() : [("subtype", subtype)],
                ("id", OpenDriveXml.Text(id)),
                ("name", name),
                ("s", OpenDriveXml.Text(place.S)),
                ("t", OpenDriveXml.Text(place.T)),
                ("zOffset", OpenDriveXml.Text(middle.Z - place.Z)),
                ("hdg", "0"),
                ("orientation", orientation),
            ]
        );
        _xml.Begin("outlines");
        _xml.Begin("outline", ("id", "0"), ("closed", isClosed ? "true" : "false"), ("outer", "true"));
        var along = new Vector2D(Math.Cos(place.Heading), Math.Sin(place.Heading));

        // The corners are relative to the place at s and t, which is not the middle if that lies beyond the road's end.
        Vector3D origin = road.Segment.Line.PointBeside(place.Parameter, -place.T);
        foreach (Vector3D corner in corners)
        {
            var apart = new Vector2D(corner.X - origin.X, corner.Y - origin.Y);
            _xml.Element(
                "cornerLocal",
                ("u", OpenDriveXml.Text(along.Dot(apart))),
                ("v", OpenDriveXml.Text(along.Cross(apart))),
                ("z", OpenDriveXml.Text(corner.Z - middle.Z)),
                ("height", "0")
            );
        }

        _xml.End();
        _xml.End();
    }

    private void WriteSignal(OpenDriveRoad road, MapSignal signal, int id)
    {
        OpenDrivePlace place = OpenDrivePlace.Of(road.Segment.Line, road.Length, signal.Position);
        bool isForward = signal.Lanes[0].IsForward;
        double facing = Math.Atan2(signal.Facing.Y, signal.Facing.X);

        // A signal for traffic along the line looks against it.
        double against = place.Heading + (isForward ? Math.PI : 0);
        (string country, string type) = TypeOf(signal.Kind);
        _xml.Begin(
            "signal",
            ("id", OpenDriveXml.Text(id)),
            ("name", signal.Id),
            ("s", OpenDriveXml.Text(place.S)),
            ("t", OpenDriveXml.Text(place.T)),
            ("zOffset", OpenDriveXml.Text(signal.Position.Z - place.Z)),
            ("hOffset", OpenDriveXml.Text(Math.IEEERemainder(facing - against, 2 * Math.PI))),
            ("orientation", isForward ? "+" : "-"),
            ("dynamic", signal.Kind == MapSignalKind.Light ? "yes" : "no"),
            ("country", country),
            ("type", type),
            ("subtype", "-1")
        );
        WriteValidity(signal.Lanes);
        if (place.Beyond > AtEnd)
        {
            _xml.Element(
                "positionInertial",
                ("x", OpenDriveXml.Text(signal.Position.X)),
                ("y", OpenDriveXml.Text(signal.Position.Y)),
                ("z", OpenDriveXml.Text(signal.Position.Z)),
                ("hdg", OpenDriveXml.Text(facing))
            );
        }

        if (signal.Model.Length > 0)
        {
            _xml.Element("userData", ("code", "model"), ("value", signal.Model));
        }

        _xml.End();
    }

    private void WriteValidity(IEnumerable<MapLane> lanes)
    {
        int[] ids = [.. lanes.Select(lane => _laneIds[lane])];
        _xml.Element("validity", ("fromLane", OpenDriveXml.Text(ids.Min())), ("toLane", OpenDriveXml.Text(ids.Max())));
    }

    private static (string Country, string Type) TypeOf(MapSignalKind kind) =>
        kind switch
        {
            MapSignalKind.Light => ("OpenDRIVE", "1000001"),
            MapSignalKind.StopSign => ("US", "R1-1"),
            MapSignalKind.GiveWay => ("US", "R1-2"),
            _ => throw new ArgumentOutOfRangeException(nameof(kind), kind, "No such kind."),
        };

    private sealed record Controller(int Id, int Junction, IReadOnlyList<int> Lights);
}
