using Harvester.Exports.Formats.NuScenes;
using Harvester.Exports.Maps;
using Harvester.Geometry;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.NuScenes;

/// <summary>The map expansion around a vehicle, compared with that of the whole network.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class NuScenesLanesTests(SimulatedSession simulated)
{
    private const double Range = 100;

    /// <summary>Distance of the places at which lanes are compared, metres; no multiple of the side of a square.</summary>
    private const double Step = 130;

    private static readonly LaneWidths Widths = new(RoadGeometry.LaneWidth, RoadGeometry.NarrowLaneWidth);

    [Fact]
    public void Lanes_around_any_place_are_those_of_the_whole_network()
    {
        RoadNetwork network = Network();
        var lanes = new NuScenesLanes(network, Widths);
        LaneNetwork whole = Whole(network);
        var content = ExpansionContent.Of(whole);
        Dictionary<string, string> texts = content.Lanes.ToDictionary(lane => lane.Id, lane => lane.ToString());
        Dictionary<string, ExpansionStopLine> stopLines = content.StopLines.ToDictionary(line => line.ToString());
        (int compared, int stops) = (0, 0);
        foreach (Vector3D place in Places(network))
        {
            HashSet<string> near = [.. whole.Index.Near(place, Range).Select(lane => lane.Id)];
            string[] found = [.. lanes.Near(place, Range)!];

            Dictionary<string, string> around = found.Where(text => !text.StartsWith('#')).ToDictionary(text => text.Split('|')[0]);
            Assert.Equal(near.Where(texts.ContainsKey).Order(StringComparer.Ordinal), around.Keys.Order(StringComparer.Ordinal));
            Assert.All(around, lane => Assert.Equal(texts[lane.Key], lane.Value));
            Assert.Equal(
                stopLines.Where(line => line.Value.Lanes.All(near.Contains)).Select(line => line.Key).Order(StringComparer.Ordinal),
                found.Where(text => text.StartsWith(ExpansionStopLine.Prefix, StringComparison.Ordinal)).Order(StringComparer.Ordinal)
            );
            compared += near.Count;
            stops += found.Count(text => text.StartsWith('#'));
        }

        Assert.True(compared > texts.Count);
        Assert.True(stops > 0);
    }

    [Fact]
    public void Lights_of_labels_have_the_lanes_that_they_govern_and_a_stop_line()
    {
        RoadNetwork network = Network();
        LaneNetwork whole = Whole(network);
        MapLane[] governed =
        [
            .. whole
                .Lanes.Where(lane => lane is { Junction: null, StopLine: null } && lane.Successors is [{ Junction: not null }, ..])
                .GroupBy(lane => (lane.Link, lane.IsForward))
                .First(group => group.Count() > 1)
                .OrderBy(lane => lane.Index),
        ];
        string[] names = [.. governed.Select(lane => lane.Id)];
        Vector3D place = governed[0].Centre[^1];
        ObjectLabel any = simulated.Open().ReadLabels().SelectMany(frame => frame.Objects).First(label => label.Parent is null);
        ObjectLabel light = any with
        {
            Id = 77,
            Class = ObjectClass.TrafficLight,
            Model = "prop_traffic_01a",
            Box3D = new(place, new Vector3D(0.5, 0.5, 2), Axes.FromHeading(90)),
            GovernedLanes = names,
        };

        string[] texts = [.. new NuScenesLanes(network, Widths).Signals([light, light with { Id = 78, GovernedLanes = [] }])];

        Assert.Equal(2, texts.Length);
        var signal = ExpansionSignal.Parse(texts[0]);
        Assert.Equal(("Light:77", MapSignalKind.Light), (signal.Id, signal.Kind));
        Assert.Equal(names, signal.Lanes);
        Assert.Equal(0, (place - signal.Position).Length, 1e-5);

        // The models of lights look towards -y of their frame: one that is turned to the west looks east.
        Assert.Equal(0, (new Vector2D(1, 0) - signal.Facing).Length, 1e-5);
        var line = ExpansionStopLine.Parse(texts[1]);
        Assert.Equal(names, line.Lanes);
        Assert.Equal(0, (Ground(governed[0].Left[^1]) - line.Outline[0]).Length, 0.001);
        Assert.Equal(0, (Ground(governed[^1].Right[^1]) - line.Outline[1]).Length, 0.001);
    }

    [Fact]
    public void Texts_of_crossings_are_read_as_they_were()
    {
        var crossing = new ExpansionCrossing("crossing:1.0,2.0,3.0", [new(1, 2), new(3, 2), new(3, 4.125)], "1:0-1:1");

        var read = ExpansionCrossing.Parse(crossing.ToString());

        Assert.Equal((crossing.Id, crossing.Road), (read.Id, read.Road));
        Assert.Equal(crossing.Corners, read.Corners);
    }

    private RoadNetwork Network() => KeptFiles.ReadRoads(simulated.OpenWithRoads())!;

    private static LaneNetwork Whole(RoadNetwork network) => LaneNetwork.Of(new RoadCurves(network), new LaneModel(network));

    private static IEnumerable<Vector3D> Places(RoadNetwork network)
    {
        Vector3D[] nodes = [.. network.Nodes.Select(node => node.Position)];
        for (double x = nodes.Min(node => node.X); x <= nodes.Max(node => node.X); x += Step)
        {
            for (double y = nodes.Min(node => node.Y); y <= nodes.Max(node => node.Y); y += Step)
            {
                yield return new Vector3D(x, y, 0);
            }
        }
    }

    private static Vector2D Ground(Vector3D point) => new(point.X, point.Y);
}
