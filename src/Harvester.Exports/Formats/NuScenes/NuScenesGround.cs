using System.Text.Json;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Files;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;

namespace Harvester.Exports.Formats.NuScenes;

/// <summary>What a session knows of drivable ground: its roads or, without them, the lanes of its labels.</summary>
internal sealed class NuScenesGround
{
    /// <summary>Roads are drawn up to this distance from the vehicle, metres.</summary>
    private const double RoadMetres = 100;

    /// <summary>Room for the shape of an object at the end of the labelling range, metres.</summary>
    private const double ObjectRoom = 20;

    /// <summary>
    /// Half the length and half the width of the ground below the vehicle, metres: it drives there, whatever is known of roads.
    /// </summary>
    private static readonly Vector2D Footprint = new(3, 1.5);

    private readonly NuScenesRoads? _roads;
    private readonly NuScenesLanes? _lanes;

    private NuScenesGround(SessionReader session, double marginMetres, NuScenesRoads? roads, NuScenesLanes? lanes)
    {
        _lanes = lanes;
        Session = session;
        MarginMetres = marginMetres;
        _roads = roads;
    }

    /// <summary>The session.</summary>
    public SessionReader Session { get; }

    /// <summary>How far the map goes beyond the places of the vehicle, metres: all objects of the labels are on it.</summary>
    public double MarginMetres { get; }

    /// <summary>Whether the lanes of the roads are known.</summary>
    public bool HasLanes => _lanes is not null;

    /// <summary>
    /// The lanes within 100 m of the vehicle with their stop lines and crossings, as texts; none without roads, null if more roads meet
    /// there than a map takes.
    /// </summary>
    public IEnumerable<string>? LanesNear(Pose ego) => _lanes is null ? [] : _lanes.Near(ego.Position, RoadMetres);

    /// <summary>The lights and signs of a label that govern lanes, as texts; none without roads.</summary>
    public IEnumerable<string> SignalsOf(FrameLabel label) => _lanes?.Signals(label.Objects) ?? [];

    /// <summary>Reads a session.</summary>
    /// <exception cref="DatasetFormatException">A file of the session is invalid; the message names it.</exception>
    public static NuScenesGround Of(SessionReader session)
    {
        string name = SessionInfo.FileName;
        try
        {
            using JsonDocument document = JsonInput.Read(session.PathOf(name));
            var header = new JsonFields(document.RootElement);
            double range = header.Has("options") ? header.Fields("options").OptionalNumber("rangeMetres") ?? 0 : 0;
            LaneWidths widths = header.Has("settings")
                ? LaneWidths.Of(header.Fields("settings"))
                : new LaneWidths(RoadGeometry.LaneWidth, RoadGeometry.NarrowLaneWidth);
            name = FramePaths.Roads;
            RoadNetwork? network = KeptFiles.ReadRoads(session);
            return new NuScenesGround(
                session,
                Math.Max(RoadMetres, range) + ObjectRoom,
                network is null ? null : new NuScenesRoads(network, widths),
                network is null ? null : new NuScenesLanes(network, widths)
            );
        }
        catch (Exception e) when (e is DatasetFormatException or JsonException or FormatException)
        {
            throw new DatasetFormatException($"{session.PathOf(name)}: {JsonFault.InText(e)}", e);
        }
    }

    /// <summary>The drivable ground near the vehicle, as polygons, metres, world.</summary>
    /// <param name="label">The label.</param>
    /// <param name="ego">The vehicle.</param>
    /// <param name="isKey">Whether the moment is a sample: those between add nothing to the roads of a network.</param>
    public IEnumerable<Vector2D[]> Near(FrameLabel label, Pose ego, bool isKey)
    {
        IEnumerable<Vector2D[]> known =
            _roads is null ? Lanes(label.Lanes?.Boundaries ?? [])
            : isKey ? _roads.Near(new Vector2D(ego.Position.X, ego.Position.Y), RoadMetres)
            : [];
        return known.Append(Below(ego));
    }

    /// <summary>The ground between the outermost boundaries of each direction. Boundary -1 is the far side of a median.</summary>
    private static IEnumerable<Vector2D[]> Lanes(IReadOnlyList<LaneLineView> boundaries)
    {
        int[] indices = [.. boundaries.Select(line => line.Index).Distinct().Order()];
        int inner = indices.Contains(-1) ? -1 : 0;
        return (
            (int[][])
                [
                    [.. indices.Where(index => index >= 0)],
                    [.. indices.Where(index => index <= inner)],
                ]
        ).Where(sides => sides.Length > 1).Select(sides => (Vector2D[])[.. PointsOf(sides[0]), .. PointsOf(sides[^1]).Reverse()]);

        IEnumerable<Vector2D> PointsOf(int index) =>
            boundaries
                .Where(line => line.Index == index)
                .SelectMany(line => line.Points)
                .Select(point => new Vector2D(point.World.X, point.World.Y));
    }

    private static Vector2D[] Below(Pose ego) =>
        [
            .. ((Vector2D[])[new(1, 1), new(1, -1), new(-1, -1), new(-1, 1)])
                .Select(corner => ego.ToWorld(new Vector3D(corner.Y * Footprint.Y, corner.X * Footprint.X, 0)))
                .Select(place => new Vector2D(place.X, place.Y)),
        ];
}
