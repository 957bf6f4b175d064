using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Lanes;

public sealed class LaneObserverTests
{
    /// <summary>The required accuracy of the indicators on roads in closed form, metres.</summary>
    private const double ExactMetres = 1e-3;

    /// <summary>The required accuracy of the angle, radians.</summary>
    private const double ExactRadians = 1e-4;

    private static readonly AnalyticRoad Straight = new((0, 200));
    private static readonly AnalyticRoad Arc = new((0.01, 200));
    private static readonly AnalyticRoad Bend = new((-0.005, 250));

    public static TheoryData<string, double, double, double> Places
    {
        get
        {
            var places = new TheoryData<string, double, double, double>();
            foreach (string road in (string[])["straight", "arc", "bend"])
            {
                foreach (double station in (double[])[60, 83.3, 107.7])
                {
                    foreach (double right in (double[])[0.9, 2.7, 4.4, 6.3, 8.1, 10.5])
                    {
                        places.Add(road, station, right, (right * 10 % 7) - 3);
                    }
                }
            }

            return places;
        }
    }

    [Theory]
    [MemberData(nameof(Places))]
    public void Observe_on_roads_in_closed_form_is_exact(string name, double station, double right, double turnDegrees)
    {
        AnalyticRoad road = name switch
        {
            "straight" => Straight,
            "arc" => Arc,
            _ => Bend,
        };
        LaneObserver observer = Observer(road.Network(2, 2, 2));

        LaneObservation seen = observer.Observe(road.At(station, right).Point, road.HeadingAt(station) + turnDegrees, 10, 4, [], null);

        Assert.Equal(LaneStatus.Known, seen.Status);
        LaneIndicators ahead = IndicatorCalculator.Compute(
            Angles.ToRadians(road.HeadingAt(station + 10) - road.HeadingAt(station) - turnDegrees),
            right,
            new LaneSection(2, 5.4),
            []
        );
        LaneIndicators here = IndicatorCalculator.Compute(Angles.ToRadians(-turnDegrees), right, new LaneSection(2, 5.4), []);
        AssertAre(ahead, seen.Indicators);
        AssertAre(here, seen.IndicatorsAtCar);
        Assert.Equal(10, seen.LookAheadMetres, ExactMetres);
    }

    [Fact]
    public void Observe_on_an_s_curve_is_exact_away_from_the_inflection()
    {
        var road = new AnalyticRoad((0.008, 120), (-0.008, 120));
        LaneObserver observer = Observer(road.Network(2, 1, 1));
        foreach (double station in (double[])[50, 80, 150, 190])
        {
            LaneObservation seen = observer.Observe(road.At(station, 2.2).Point, road.HeadingAt(station), 10, 4, [], null);

            AssertAre(
                IndicatorCalculator.Compute(
                    Angles.ToRadians(Math.IEEERemainder(road.HeadingAt(station + 10) - road.HeadingAt(station), 360)),
                    2.2,
                    new LaneSection(1, 5.4),
                    []
                ),
                seen.Indicators
            );
        }
    }

    [Fact]
    public void Observe_assigns_vehicles_along_the_curve_to_lanes()
    {
        LaneObserver observer = Observer(Arc.Network(2, 2, 1));
        TrafficVehicle[] vehicles =
        [
            At(Arc, 1, station: 100, right: 8.1, length: 5), // 40 m ahead in the right lane
            At(Arc, 2, station: 90, right: 2.7, length: 4), // 30 m ahead in the left lane
            At(Arc, 3, station: 40, right: 2.7, length: 4), // behind
            At(Arc, 4, station: 135, right: 2.7, length: 4), // 75 m ahead: out of range
            At(Arc, 5, station: 80, right: -2.7, length: 4, turned: 180), // oncoming
            At(Arc, 6, station: 85, right: 14, length: 4), // parked beside the lanes
        ];

        LaneObservation seen = observer.Observe(Arc.At(60, 2.7).Point, Arc.HeadingAt(60), 10, 3, vehicles, null);

        Assert.Equal([5, 2, 1], seen.Vehicles.Select(vehicle => vehicle.Id));
        Assert.Equal([true, false, false], seen.Vehicles.Select(vehicle => vehicle.IsOncoming));
        Assert.Equal([0, 0, 1], seen.Vehicles.Select(vehicle => vehicle.Lane));
        Assert.Equal(30, seen.Indicators.DistMM.Value, ExactMetres * 10);
        Assert.Equal(40, seen.Indicators.DistRR.Value, ExactMetres * 10);

        // Bumper to bumper: 30 - (3 + 4) / 2.
        Assert.Equal(26.5, seen.Vehicles[1].BumperDistanceMetres, ExactMetres * 10);
    }

    [Fact]
    public void Observe_straight_road_is_fast_and_a_bend_is_not()
    {
        Assert.True(Observer(Straight.Network(5, 1, 1)).Observe(Straight.At(50, 2.7).Point, 0, 10, 4, [], null).IsFast);
        Assert.False(Observer(Arc.Network(5, 1, 1)).Observe(Arc.At(50, 2.7).Point, Arc.HeadingAt(50), 10, 4, [], null).IsFast);
    }

    [Fact]
    public void Observe_curvature_is_that_of_the_look_ahead_point()
    {
        LaneObservation seen = Observer(Arc.Network(2, 1, 1)).Observe(Arc.At(50, 2.7).Point, Arc.HeadingAt(50), 10, 4, [], null);

        Assert.Equal(0.01, seen.CurvaturePerMetre, 2e-4);
    }

    [Fact]
    public void Observe_beside_every_road_is_off_road_without_indicators()
    {
        LaneObservation seen = Observer(Straight.Network(5, 1, 1)).Observe(new Vector3D(80, 50, 0), 0, 10, 4, [], null);

        Assert.Equal(LaneStatus.OffRoad, seen.Status);
        Assert.Equal(LaneIndicators.Unknown, seen.Indicators);
        Assert.Empty(seen.Vehicles);
    }

    [Fact]
    public void Observe_in_a_junction_reports_it_without_indicators()
    {
        RoadNode[] nodes =
        [
            Node(0, 0, -100),
            Node(1, 0, -50),
            Node(2, 0, 0, RoadNodeFlags.Junction),
            Node(3, 0, 50),
            Node(4, 50, 0),
            Node(5, -50, 0),
        ];
        RoadLink[] links = [Link(0, 1), Link(1, 2), Link(2, 3), Link(2, 4), Link(2, 5)];
        LaneObserver observer = Observer(new RoadNetwork(nodes, links));

        Assert.Equal(LaneStatus.InJunction, observer.Observe(new Vector3D(2.7, -3, 0), 0, 10, 4, [], null).Status);
        Assert.Equal(LaneIndicators.Unknown, observer.Observe(new Vector3D(2.7, -3, 0), 0, 10, 4, [], null).Indicators);
        Assert.Equal(LaneStatus.Known, observer.Observe(new Vector3D(2.7, -70, 0), 0, 10, 4, [], null).Status);
    }

    [Theory]
    [InlineData(1.9, true)]
    [InlineData(2.1, false)]
    public void Observe_outside_the_lanes_stays_on_marking_for_two_metres(double outside, bool isKnown)
    {
        const double scale = 5.4 / 4;
        LaneObserver observer = Observer(Straight.Network(5, 2, 0));

        LaneObservation right = observer.Observe(Straight.At(50, 5.4 + (outside * scale)).Point, 0, 10, 4, [], null);
        LaneObservation left = observer.Observe(Straight.At(50, -5.4 - (outside * scale)).Point, 0, 10, 4, [], null);

        Assert.Equal([isKnown, isKnown], new[] { right, left }.Select(seen => seen.Status == LaneStatus.Known));
        Assert.Equal([isKnown, isKnown], new[] { right, left }.Select(seen => seen.IndicatorsAtCar.ToMarkingM.IsValid));
        if (isKnown)
        {
            Assert.Equal(-outside * scale, right.IndicatorsAtCar.ToMarkingM.Value, ExactMetres);
            Assert.Equal(outside * scale, left.IndicatorsAtCar.ToMarkingM.Value, ExactMetres);
            Assert.False(right.IndicatorsAtCar.ToMarkingR.IsValid || right.IndicatorsAtCar.ToMarkingMR.IsValid);
            Assert.False(left.IndicatorsAtCar.ToMarkingL.IsValid || left.IndicatorsAtCar.ToMarkingML.IsValid);
        }
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(-1, 0)]
    [InlineData(1, 15)]
    [InlineData(1, -15)]
    [InlineData(-1, 15)]
    public void Observe_in_a_sharp_bend_ignores_the_ends_of_links(int side, double turned)
    {
        // A radius of 15 m; a cubic between nodes 4 m apart keeps to such a circle within a millimetre.
        const double curveMetres = 0.002;
        const double curveRadians = 0.002;
        var bend = new AnalyticRoad((0, 20), (side / 15.0, 40), (0, 20));
        LaneObserver observer = Observer(bend.Network(4, 1, 1));
        RoadMatch? previous = null;
        for (double station = 26; station < 54; station += 0.1)
        {
            LaneObservation seen = observer.Observe(bend.At(station, 2.2).Point, bend.HeadingAt(station) + turned, 5, 4, [], previous);
            previous = seen.Match;

            Assert.Equal(2.2, seen.Match.OffsetFromLeftEdge, curveMetres);
            Assert.Equal(-Angles.ToRadians(turned), seen.IndicatorsAtCar.Angle.Value, curveRadians);
        }
    }

    [Fact]
    public void Observe_look_ahead_by_speed_is_one_second_of_travel()
    {
        RoadNetwork network = Straight.Network(5, 1, 1);
        var observer = new LaneObserver(new RoadCurves(network), new LaneModel(network), LookAhead.OfSeconds(1));

        Assert.Equal(17, observer.Observe(Straight.At(50, 2.7).Point, 0, 17, 4, [], null).LookAheadMetres, ExactMetres);
    }

    [Fact]
    public void Trace_gives_all_boundaries_of_both_directions()
    {
        RoadNetwork network = Straight.Network(5, 2, 1, median: 2);
        LaneObservation seen = Observer(network).Observe(Straight.At(50, 1 + 2.7).Point, 0, 10, 4, [], null);

        IReadOnlyList<LaneLine> lines = LaneLineTracer.Trace(seen.Stretch!, 3.7, 0, 50);

        // Own: 1, 6.4, 11.8 m right of the line; oncoming: 1 and 6.4 m left of it.
        Assert.Equal([-2, -1, 0, 1, 2], lines.Select(line => line.Index));
        Assert.Equal([-6.4, -1, 1, 6.4, 11.8], lines.Select(line => Math.Round(line.Points[0].World.X, 6)));
        Assert.Equal([true, true, true, false, false], lines.Select(line => line.IsLeftOfCar));
        Assert.All(lines, line => Assert.Equal(100, line.Points[^1].World.Y, ExactMetres));
    }

    [Fact]
    public void Trace_skips_the_junction_and_continues_beyond_it()
    {
        RoadNode[] nodes = [Node(0, 0, -100), Node(1, 0, 0), Node(2, 0, 100), Node(3, 100, 0)];
        LaneObservation seen = Observer(new RoadNetwork(nodes, [Link(0, 1), Link(1, 2), Link(1, 3)]))
            .Observe(new Vector3D(2.7, -30, 0), 0, 10, 4, [], null);

        IReadOnlyList<LaneLine> lines = LaneLineTracer.Trace(seen.Stretch!, 2.7, 0, 60);

        // Three boundaries before and three after; the other road is 5.4 m wide on either side, its corners take 1.5 m; points are up to 2
        // m apart.
        Assert.Equal(6, lines.Count);
        Assert.All(lines.SelectMany(line => line.Points), point => Assert.InRange(Math.Abs(point.World.Y), 6.9, 30.5));
        Assert.All(lines.Where(line => line.Points[0].World.Y < 0), line => Assert.InRange(line.Points[^1].World.Y, -8.9, -6.9));
        Assert.All(lines.Where(line => line.Points[0].World.Y > 0), line => Assert.InRange(line.Points[0].World.Y, 6.9, 8.9));
    }

    [Fact]
    public void Car_keeps_its_place_between_painted_lines()
    {
        // Both edges of the lane move by 2 cm a metre to the right of the road's line.
        RoadNetwork network = Straight.Network(1, 1, 0);
        Dictionary<(int Link, bool IsForward), MeasuredLanes> measured = Enumerable
            .Range(0, network.Links.Count)
            .ToDictionary(
                link => (link, true),
                link =>
                {
                    RoadLink road = network.Links[link];
                    double Edge(int node) => 0.02 * (network.Nodes[node].Position - network.Nodes[network.Links[0].From].Position).Length;
                    double length = (network.Nodes[road.To].Position - network.Nodes[road.From].Position).Length;
                    var lanes = new LaneSection([3.5]);
                    return new MeasuredLanes([
                        (0, new MeasuredSection(Edge(road.From), lanes, true)),
                        (length, new MeasuredSection(Edge(road.To), lanes, true)),
                    ]);
                }
            );
        var observer = new LaneObserver(new RoadCurves(network), new LaneModel(network, measured: measured));

        LaneObservation seen = observer.Observe(Straight.At(60, 2.5).Point, Straight.HeadingAt(60), 10, 4, [], null);

        // At 60 m, the left edge is at 1.2 m.
        Assert.Equal(-1.3, seen.IndicatorsAtCar.ToMarkingML.Value, ExactMetres);
        Assert.Equal(-1.3, seen.Indicators.ToMarkingML.Value, ExactMetres);
        Assert.Equal(2.2, seen.Indicators.ToMarkingMR.Value, ExactMetres);
        Assert.Equal(LaneWidthSource.Paint, seen.WidthSource);
    }

    private static LaneObserver Observer(RoadNetwork network) => new(new RoadCurves(network), new LaneModel(network));

    private static TrafficVehicle At(AnalyticRoad road, int id, double station, double right, double length, double turned = 0) =>
        new(id, road.At(station, right).Point, road.HeadingAt(station) + turned, length);

    private static RoadNode Node(int number, double x, double y, RoadNodeFlags flags = RoadNodeFlags.None) =>
        new(0, number, new Vector3D(x, y, 0), string.Empty, flags);

    private static RoadLink Link(int from, int to) => new(from, to, 1, 1, null, RoadLinkFlags.None);

    private static void AssertAre(LaneIndicators expected, LaneIndicators actual)
    {
        AssertIs(expected.Angle, actual.Angle, ExactRadians);
        AssertIs(expected.ToMarkingL, actual.ToMarkingL, ExactMetres);
        AssertIs(expected.ToMarkingM, actual.ToMarkingM, ExactMetres);
        AssertIs(expected.ToMarkingR, actual.ToMarkingR, ExactMetres);
        AssertIs(expected.ToMarkingLL, actual.ToMarkingLL, ExactMetres);
        AssertIs(expected.ToMarkingML, actual.ToMarkingML, ExactMetres);
        AssertIs(expected.ToMarkingMR, actual.ToMarkingMR, ExactMetres);
        AssertIs(expected.ToMarkingRR, actual.ToMarkingRR, ExactMetres);
    }

    private static void AssertIs(Indicator expected, Indicator actual, double tolerance)
    {
        Assert.Equal(expected.IsValid, actual.IsValid);
        Assert.Equal(expected.Value, actual.Value, tolerance);
    }
}
