using System.Xml.Linq;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
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

    private static readonly LaneNetwork Map = FurnishedMap(471);
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
    public void Same_roads_give_the_same_bytes() => Assert.Equal(Text(Map), Text(FurnishedMap(471)));

    [Fact]
    public void Signals_are_valid_for_the_lanes_that_they_govern()
    {
        MapSignal[] governing = [.. Map.Signals.Where(signal => signal.Lanes.Count > 0)];
        Dictionary<string, XElement> signals = File.Descendants("signal").ToDictionary(signal => signal.Attribute("name")!.Value);

        Assert.True(governing.Length > 20);
        Assert.Equal(governing.Length, signals.Count);
        foreach (MapSignal signal in governing)
        {
            XElement written = signals[signal.Id];
            XElement validity = written.Element("validity")!;
            (int from, int to) = (Whole(validity, "fromLane"), Whole(validity, "toLane"));
            string road = written.Parent!.Parent!.Attribute("id")!.Value;
            string[] valid = [.. Lanes.Where(lane => lane.RoadId == road && lane.Id >= from && lane.Id <= to).Select(lane => lane.Name)];

            Assert.Equal(signal.Lanes.Select(lane => lane.Id).Order(StringComparer.Ordinal), valid.Order(StringComparer.Ordinal));
            Assert.Equal(from < 0 ? "+" : "-", written.Attribute("orientation")!.Value);
            Assert.Equal(signal.Kind == MapSignalKind.Light ? "yes" : "no", written.Attribute("dynamic")!.Value);

            // A signal beyond the end of its road has its place besides.
            Vector3D place = written.Element("positionInertial") is { } inertial
                ? new Vector3D(
                    OpenDriveLane.Number(inertial, "x"),
                    OpenDriveLane.Number(inertial, "y"),
                    OpenDriveLane.Number(inertial, "z")
                )
                : OpenDriveLine.PlaceOf(written, OpenDriveLane.Number(written, "t"));
            Assert.InRange((place - signal.Position).Length, 0, MaxDeviation);
        }
    }

    [Fact]
    public void Lights_of_an_approach_have_a_controller_of_its_junction()
    {
        string[] lights =
        [
            .. File.Descendants("signal")
                .Where(signal => signal.Attribute("dynamic")!.Value == "yes")
                .Select(light => light.Attribute("id")!.Value),
        ];
        XElement[] controllers = [.. File.Elements("controller")];

        Assert.Equal(
            lights.Order(StringComparer.Ordinal),
            controllers.Elements("control").Select(control => control.Attribute("signalId")!.Value).Order(StringComparer.Ordinal)
        );
        Assert.Equal(
            controllers.Select(controller => controller.Attribute("id")!.Value).Order(StringComparer.Ordinal),
            File.Elements("junction").Elements("controller").Select(used => used.Attribute("id")!.Value).Order(StringComparer.Ordinal)
        );
    }

    [Fact]
    public void Outlines_lie_where_the_map_has_stop_lines_and_crossings()
    {
        Dictionary<string, XElement> objects = File.Descendants("object").ToDictionary(item => item.Attribute("name")!.Value);

        Assert.Equal(Map.StopLines.Count + Map.Crossings.Count, objects.Count);
        Assert.Contains(Map.StopLines, line => line.Source == MapSource.Known);
        foreach (MapStopLine line in Map.StopLines)
        {
            AssertCorners([line.Left, line.Right], objects[line.Id]);
        }

        foreach (MapCrossing crossing in Map.Crossings)
        {
            Assert.Equal("crosswalk", objects[crossing.Id].Attribute("type")!.Value);
            AssertCorners(crossing.Corners, objects[crossing.Id]);
        }
    }

    [Fact]
    public void Road_marks_are_the_lines_on_the_right_of_lanes()
    {
        int marked = 0;
        foreach (OpenDriveLane lane in Lanes)
        {
            XElement? mark = lane.Mark;
            MarkingPaint? paint = Map.Find(lane.Name)!.RightMarking?.Paint;
            marked += mark is null ? 0 : 1;
            Assert.Equal(paint is null, mark is null);
            if (paint is { } line)
            {
                string type = line.Style switch
                {
                    MarkingStyle.Solid => "solid",
                    MarkingStyle.Dashed => "broken",
                    _ => "solid solid",
                };
                Assert.Equal(type, mark!.Attribute("type")!.Value);
                Assert.Equal(line.Colour == MarkingColour.Yellow ? "yellow" : "white", mark.Attribute("color")!.Value);
                Assert.Equal(line.WidthMetres, OpenDriveLane.Number(mark, "width"), 1e-9);
            }
        }

        Assert.True(marked > 20);
    }

    [Fact]
    public void Lanes_whose_width_changes_have_widths_in_pieces()
    {
        RoadNetwork network = new(
            [
                new RoadNode(1, 0, new Vector3D(0, 0, 0), "", RoadNodeFlags.None),
                new RoadNode(1, 1, new Vector3D(80, 0, 0), "", RoadNodeFlags.None),
            ],
            [new RoadLink(0, 1, 1, 0, null, RoadLinkFlags.None)]
        );
        MeasuredSection Section(double left, double width) => new(left, new LaneSection([width]), true);
        var measured = new MeasuredLanes([(0, Section(-2, 4)), (40, Section(-2, 4)), (80, Section(-1, 3))]);

        XElement file = Read(
            LaneNetwork.Of(
                new RoadCurves(network),
                new LaneModel(network, measured: new Dictionary<(int, bool), MeasuredLanes> { [(0, true)] = measured })
            )
        );

        // From 40 m on, the left edge moves right by 1 m in 40 m, and the right edge stays.
        XElement[] widths = [.. file.Descendants("width")];
        XElement[] offsets = [.. file.Descendants("laneOffset")];
        Assert.Equal([(0.0, 4.0, 0.0), (40.0, 4.0, -0.025)], widths.Select(width => Piece(width, "sOffset")));
        Assert.Equal([(0.0, 2.0, 0.0), (40.0, 2.0, -0.025)], offsets.Select(offset => Piece(offset, "s")));
    }

    private static (double, double, double) Piece(XElement piece, string station) =>
        (OpenDriveLane.Number(piece, station), OpenDriveLane.Number(piece, "a"), OpenDriveLane.Number(piece, "b"));

    private static void AssertCorners(IReadOnlyList<Vector3D> wanted, XElement item)
    {
        Vector3D[] corners = [.. item.Descendants("cornerLocal").Select(corner => OpenDriveLine.CornerOf(item, corner))];
        Assert.Equal(wanted.Count, corners.Length);
        Assert.All(wanted.Zip(corners), pair => Assert.InRange((pair.First - pair.Second).Length, 0, MaxDeviation));
    }

    private static int Whole(XElement element, string name) => (int)OpenDriveLane.Number(element, name);

    /// <summary>A town's map with a light or a sign to the right of every road to a junction, and paint along and across some.</summary>
    private static LaneNetwork FurnishedMap(int seed)
    {
        RoadNetwork network = TownBuilder.Build(seed);
        RoadCurves curves = new(network);
        LaneModel model = new(network);
        MapLane[] ends =
        [
            .. LaneNetwork
                .Of(curves, model)
                .Lanes.Where(lane =>
                    lane is { Junction: null, RightNeighbour: null } && lane.Successors.Any(way => way.Junction is not null)
                ),
        ];
        var white = new MarkingPaint(MarkingStyle.Solid, MarkingColour.White, 0.15);
        var yellow = new MarkingPaint(MarkingStyle.DoubleSolid, MarkingColour.Yellow, 0.3);
        return LaneNetwork.Of(
            curves,
            model,
            new MapContent
            {
                Props =
                [
                    .. ends.Select(
                        (lane, index) =>
                            new MapProp(
                                index % 5 == 0 ? MapSignalKind.StopSign : MapSignalKind.Light,
                                "",
                                lane.Right[^1] + Across(lane, 1.5),
                                Along(lane, -1)
                            )
                    ),
                ],
                KnownLines =
                [
                    .. ends.Select((lane, index) => new PaintedLine(index % 3 == 0 ? yellow : white, [.. lane.Right.Select(Painted)])),
                    .. ends.Select(lane => new PaintedLine(
                        new MarkingPaint(MarkingStyle.Dashed, MarkingColour.White, 0.15),
                        [.. lane.Left.Select(Painted)]
                    )),
                ],
                KnownMarks =
                [
                    .. ends.Where((_, index) => index % 2 == 0).Select(lane => Bar(MarkKind.StopLine, lane, 1, 0.5)),
                    .. ends.Where((_, index) => index % 4 == 0).Select(lane => Bar(MarkKind.Crossing, lane, -1, -4)),
                ],
            }
        );
    }

    private static LinePoint Painted(Vector3D place) => new(place, true);

    private static Vector3D Along(MapLane lane, double metres) => new Vector3D(lane.EndDirection.X, lane.EndDirection.Y, 0) * metres;

    private static Vector3D Across(MapLane lane, double metres) => new Vector3D(lane.EndDirection.Y, -lane.EndDirection.X, 0) * metres;

    /// <summary>An area across a lane between two distances before its end.</summary>
    private static PaintedMark Bar(MarkKind kind, MapLane lane, double from, double to) =>
        new(
            kind,
            [
                lane.Right[^1] - Along(lane, from),
                lane.Right[^1] - Along(lane, to),
                lane.Left[^1] - Along(lane, to),
                lane.Left[^1] - Along(lane, from),
            ]
        );

    private static Vector3D StartOf(OpenDriveLane lane) => lane.MiddleAt(lane.Id < 0 ? 0 : 1);

    private static Vector3D EndOf(OpenDriveLane lane) => lane.MiddleAt(lane.Id < 0 ? 1 : 0);

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
