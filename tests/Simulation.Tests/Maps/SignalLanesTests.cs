using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Maps;
using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;
using Harvester.Simulation.Tests.Labelling;
using Harvester.Simulation.Traffic;
using Harvester.Simulation.World;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Maps;

/// <summary>The lights, signs and painted marks of a town's map, compared with those that its traffic obeys.</summary>
public sealed class SignalLanesTests(ITestOutputHelper output)
{
    /// <summary>Labels have places to a millimetre or so, metres.</summary>
    private const double SameLight = 0.01;

    [Theory]
    [InlineData(486)]
    [InlineData(487)]
    [InlineData(488)]
    [Trait("Category", "Heavy")]
    public void Lights_and_signs_govern_the_lanes_that_obey_them(int seed)
    {
        Site site = Site.OfTown(seed);
        (Prop Prop, RoadArm Arm)[] truth = [.. LightsOf(site), .. SignsOf(site, seed)];
        LaneNetwork map = MapOf(site, truth.Select(pair => pair.Prop));
        LanePath[] roads = [.. site.Lanes.Paths.Where(path => path.Road is not null && path.Length > 0)];
        int wrong = 0;
        Assert.Equal(truth.Length, map.Signals.Count);
        foreach ((MapSignal signal, (Prop prop, RoadArm arm)) in map.Signals.Zip(truth))
        {
            var wanted = Enumerable.Range(0, arm.Road.Layout.Lanes(!arm.AtStart)).Select(lane => (arm.Road, !arm.AtStart, lane)).ToList();
            var found = signal.Lanes.Select(lane => PathOf(lane, roads)).Select(path => (path?.Road, path?.IsForward, path?.Lane)).ToList();
            if (!wanted.Select(lane => ((Road?)lane.Road, (bool?)lane.Item2, (int?)lane.lane)).SequenceEqual(found))
            {
                wrong++;
                output.WriteLine(
                    $"{signal.Id} {prop.Model.Name} obeyed by road {arm.Road.Index} ({wanted.Count} lanes), found "
                        + string.Join("; ", found.Select(lane => $"{lane.Road?.Index} {lane.IsForward} {lane.Lane}"))
                );
            }
        }

        output.WriteLine($"{truth.Length} lights and signs, {wrong} wrong; {map.Signals.Count(s => s.Kind == MapSignalKind.Light)} lights");
        Assert.True(truth.Length > 0);
        Assert.Equal(0, wrong);
    }

    [Theory]
    [InlineData(486)]
    [InlineData(487)]
    [InlineData(488)]
    public void Painted_stop_lines_are_those_of_the_lanes_before_them(int seed)
    {
        Site site = Site.OfTown(seed);
        LaneNetwork map = MapOf(site, LightsOf(site).Select(pair => pair.Prop));
        MapStopLine[] painted = [.. map.StopLines.Where(line => line.Source == MapSource.Known)];

        output.WriteLine(
            $"{painted.Length} painted, {map.StopLines.Count - painted.Length} derived, {map.Crossings.Count} crossings; "
                + $"{site.Marks.Count(mark => mark.Kind == MarkKind.StopLine)} lines painted"
        );

        // What is left of a road between the stop lines of two junctions is part of them in the map.
        Assert.Equal(
            site.Plan.Junctions.Where(junction => junction.IsCrossing)
                .SelectMany(junction => junction.Arms)
                .Count(arm =>
                    arm.Road is { IsStreet: true, IsTooShortToWait: false }
                    && arm.Road.Length > 2 * arm.Trim
                    && arm.Road.Layout.Lanes(!arm.AtStart) > 0
                ),
            painted.Length
        );
        Assert.Equal(site.Marks.Count(mark => mark.Kind == MarkKind.Crossing), map.Crossings.Count);
        Assert.Equal(map.StopLines.Count, map.StopLines.Select(line => line.Id).Distinct().Count());
        Assert.All(map.Signals, signal => Assert.NotNull(signal.StopLine));
        Assert.All(painted, line => Assert.Null(line.Lanes[0].LeftNeighbour));
        Assert.All(painted, line => Assert.Null(line.Lanes[^1].RightNeighbour));
        Assert.All(
            painted,
            line => Assert.True(line.Lanes[0].EndDirection.Cross(new Vector2D(line.Right.X - line.Left.X, line.Right.Y - line.Left.Y)) < 0)
        );
    }

    [Theory]
    [InlineData(484)]
    public void Known_lines_mark_the_lanes_beside_them(int seed)
    {
        Site site = Site.OfTown(seed);
        LaneNetwork map = MapOf(site, []);
        MapLane[] lanes = [.. map.Lanes.Where(lane => lane.Junction is null)];

        int marked = lanes.Count(lane => lane.LeftMarking is not null);
        output.WriteLine(
            $"{marked} of {lanes.Length} lanes have a left marking, {lanes.Count(l => l.RightMarking is not null)} a right one"
        );
        Assert.InRange(marked, lanes.Length / 2, lanes.Length);
        Assert.All(
            lanes.Where(lane => lane.RightNeighbour is not null),
            lane => Assert.Same(lane.RightMarking, lane.RightNeighbour!.LeftMarking)
        );
    }

    [Theory]
    [InlineData(611)]
    [InlineData(612)]
    [Trait("Category", "Heavy")]
    public void Labels_name_the_lanes_that_obey_lights(int seed)
    {
        Site site = Site.OfTown(seed);
        LaneNetwork map = LaneNetwork.Of(new RoadCurves(site.Network), new LaneModel(site.Network));
        LanePath[] roads = [.. site.Lanes.Paths.Where(path => path.Road is not null && path.Length > 0)];
        (Vector3D Centre, RoadArm Arm)[] truth =
        [
            .. LightsOf(site)
                .Select(light => (light.Prop.State.Pose.ToWorld((light.Prop.State.ModelMin + light.Prop.State.ModelMax) * 0.5), light.Arm)),
        ];
        var game = new SimulatedGame(new SimulationOptions { Seed = seed });
        var options = new HarvestOptions
        {
            Image = new ImageSize(320, 240),
            MaxFrames = 20,
            RateHz = 0.5,
            Classes = [ObjectClass.TrafficLight],
        };
        var judged = new HashSet<Vector3D>();
        LabelledTown.Harvest(
            game,
            game.Ports with
            {
                Roads = new FixedRoads(site.Network, "town"),
            },
            options,
            (frame, _) =>
            {
                foreach (ObjectLabel light in frame.Label.Objects.Where(label => label is { Parent: null, GovernedLanes: not null }))
                {
                    (Vector3D centre, RoadArm arm) = truth.MinBy(each => (each.Centre - light.Box3D.Centre).Length);
                    Assert.Equal(0, (centre - light.Box3D.Centre).Length, SameLight);
                    judged.Add(centre);
                    Assert.Equal(
                        Enumerable.Range(0, arm.Road.Layout.Lanes(!arm.AtStart)).Select(lane => (arm.Road.Index, !arm.AtStart, lane)),
                        light
                            .GovernedLanes!.Select(id => PathOf(map.Find(id)!, roads)!)
                            .Select(path => (path.Road!.Index, path.IsForward, path.Lane))
                    );
                }
            }
        );

        output.WriteLine($"{judged.Count} lights");
        Assert.NotEmpty(judged);
    }

    private static LaneNetwork MapOf(Site site, IEnumerable<Prop> props) =>
        LaneNetwork.Of(
            new RoadCurves(site.Network),
            new LaneModel(site.Network),
            new MapContent
            {
                Props = [.. props.Select(prop => MapProps.Of(prop.Model.Name, prop.Pose)!)],
                KnownLines = site.Paint,
                KnownMarks = site.Marks,
            }
        );

    private static IEnumerable<(Prop Prop, RoadArm Arm)> LightsOf(Site site)
    {
        var lights = new SignalProps(site.Signals, new HandleCounter());
        lights.AddAtStopLines(site.Index, ModelCatalogue.Shared);
        return lights.Lights.Select(light => (light.Prop, light.Arm));
    }

    private static List<(Prop Prop, RoadArm Arm)> SignsOf(Site site, int seed)
    {
        var scenery = new Scenery(seed, site, ModelCatalogue.Shared, new HandleCounter());
        scenery.AddStopSigns(site.Plan, site.Signals.Has);
        return scenery.WaitSigns;
    }

    /// <summary>The path of the traffic on which a lane ends; the nearest one in its direction.</summary>
    private static LanePath? PathOf(MapLane lane, LanePath[] paths)
    {
        Vector3D end = lane.Centre[^1];
        var ahead = new Vector3D(lane.EndDirection.X, lane.EndDirection.Y, 0);
        return paths
            .Where(path => path.Line.TangentAt(path.Length).Dot(ahead) > 0.7)
            .MinBy(path => path.Line.Points.Min(point => Horizontal.Distance(point, end)));
    }
}
