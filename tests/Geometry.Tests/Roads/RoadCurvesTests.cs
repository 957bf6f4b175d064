using FsCheck;
using FsCheck.Fluent;
using Harvester.Geometry.Roads;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests.Roads;

public sealed class RoadCurvesTests
{
    /// <summary>The required accuracy of the markings, metres RMS.</summary>
    private const double MaxMarkingError = 0.1;

    private static readonly Vector3D Middle = new(1200, -900, 30);

    [Theory]
    [InlineData(25)]
    [InlineData(60)]
    [InlineData(150)]
    [InlineData(-400)]
    public void Markings_of_an_arc_with_truncated_nodes_are_within_10_cm(double radius)
    {
        // Right of a left turn (positive radius) a marking lies further from the centre of the circle.
        double sum = 0;
        int count = 0;
        for (int seed = 0; seed < 20; seed++)
        {
            RoadNetwork road = Truncated(ArcPoints(radius, new Random(seed), angle: Math.Min(4, 300 / Math.Abs(radius))));
            var curves = new RoadCurves(road);
            foreach (double offset in new[] { -5.4, 0, 5.4, 10.8 })
            {
                ForEachPoint(
                    curves,
                    offset,
                    point =>
                    {
                        double fromCentre = Math.Sqrt(Square(point.X - Middle.X) + Square(point.Y - Middle.Y));
                        sum += Square(fromCentre - Math.Abs(radius + offset));
                        count++;
                    }
                );
            }
        }

        Assert.InRange(Math.Sqrt(sum / count), 0, MaxMarkingError);
    }

    [Fact]
    public void Markings_of_an_s_curve_with_truncated_nodes_are_within_10_cm()
    {
        // A left turn about Middle, then a right turn of the same radius about the point that lies twice as far away.
        const double radius = 80;
        double sum = 0;
        int count = 0;
        for (int seed = 0; seed < 20; seed++)
        {
            List<Vector3D> points = ArcPoints(radius, new Random(seed), angle: 1);
            Vector3D turn = Middle + new Vector3D(radius * Math.Cos(1), radius * Math.Sin(1), 0);
            Vector3D second = turn + (turn - Middle);
            points.AddRange(
                ArcPoints(radius, new Random(seed + 99), angle: 1)
                    .Skip(1)
                    .Select(point =>
                    {
                        double along = Math.Atan2(point.Y - Middle.Y, point.X - Middle.X);
                        return second + new Vector3D(-radius * Math.Cos(1 - along), -radius * Math.Sin(1 - along), 0);
                    })
            );
            var curves = new RoadCurves(Truncated(points));
            foreach (double offset in new[] { -5.4, 0, 5.4 })
            {
                ForEachPoint(
                    curves,
                    offset,
                    point =>
                    {
                        double first = Math.Abs(Math.Sqrt(Square(point.X - Middle.X) + Square(point.Y - Middle.Y)) - (radius + offset));
                        double then = Math.Abs(Math.Sqrt(Square(point.X - second.X) + Square(point.Y - second.Y)) - (radius - offset));
                        sum += Square(Math.Min(first, then));
                        count++;
                    }
                );
            }
        }

        Assert.InRange(Math.Sqrt(sum / count), 0, MaxMarkingError);
    }

    [Fact]
    public void Curve_through_nodes_on_a_circle_is_that_circle()
    {
        // Nodes are exact here; the rest is what a cubic of at most 12 m leaves of a circle of 40 m.
        var curves = new RoadCurves(Road(ArcPoints(40, new Random(3), angle: 3)));
        ForEachPoint(curves, 0, point => Assert.InRange(Math.Sqrt(Square(point.X - Middle.X) + Square(point.Y - Middle.Y)), 39.99, 40.01));

        double length = Enumerable.Range(0, curves.Network.Links.Count).Sum(i => curves.Of(i).Length);
        Assert.InRange(length, (40 * 3) - 0.05, (40 * 3) + 0.05);
    }

    [Fact]
    public void Curve_is_smooth_at_every_node_whatever_the_link_direction()
    {
        RoadNetwork straight = Road(ArcPoints(30, new Random(1), angle: 2));
        RoadLink[] turned = [.. straight.Links.Select((link, i) => i % 2 == 0 ? link : link.Reversed())];
        var curves = new RoadCurves(new RoadNetwork(straight.Nodes, turned));

        for (int i = 1; i < turned.Length; i++)
        {
            Vector2D before = Along(i - 1, atEnd: true);
            Vector2D after = Along(i, atEnd: false);
            Assert.Equal(1, before.Dot(after), 9);
        }

        Vector2D Along(int link, bool atEnd) =>
            link % 2 == 0 ? curves.Of(link).DirectionAt(atEnd ? 1 : 0) : curves.Of(link).DirectionAt(atEnd ? 0 : 1) * -1;
    }

    [Fact]
    public void ParameterAt_and_StationAt_are_each_others_inverse()
    {
        RoadCurve curve = new RoadCurves(Road(ArcPoints(20, new Random(2), angle: 3))).Of(2);
        for (double station = 0; station <= curve.Length; station += 0.25)
        {
            // A millimetre: the parameter is found by one step of Newton's method in an eighth of a link.
            Assert.InRange(curve.StationAt(curve.ParameterAt(station)) - station, -0.001, 0.001);
        }

        Assert.Equal(0, curve.ParameterAt(-3));
        Assert.Equal(1, curve.ParameterAt(curve.Length + 3));
    }

    [Fact]
    public void ClosestParameter_is_as_near_as_a_dense_search()
    {
        var curves = new RoadCurves(Road(ArcPoints(20, new Random(4), angle: 3)));
        Arbitrary<int> links = RandomCases.Integer(0, curves.Network.Links.Count - 1);
        RandomCases.Check(
            500,
            Arb.Zip(links, Arb.Zip(RandomCases.Number(-10, 10), RandomCases.Number(-10, 10))),
            drawn =>
            {
                (int link, (double x, double y)) = drawn;
                RoadCurve curve = curves.Of(link);
                Vector3D start = curve.PointAt(0.5);
                var place = new Vector2D(start.X + x, start.Y + y);
                double found = Apart(curve.ClosestParameter(place));
                double dense = Enumerable.Range(0, 1001).Min(step => Apart(step / 1000.0));
                Assert.InRange(found, 0, dense + 0.001);

                double Apart(double parameter)
                {
                    Vector3D point = curve.PointAt(parameter);
                    return (new Vector2D(point.X, point.Y) - place).Length;
                }
            }
        );
    }

    [Fact]
    public void CurvatureAt_of_a_left_turn_is_one_over_the_radius()
    {
        var curves = new RoadCurves(Road(ArcPoints(50, new Random(6), angle: 2)));

        Assert.Equal(1 / 50.0, curves.Of(3).CurvatureAt(0.5), 4);
    }

    /// <summary>
    /// Nodes 5 to 12 m apart on a circle about <see cref="Middle"/>, counter-clockwise; a negative radius drives it clockwise.
    /// </summary>
    private static List<Vector3D> ArcPoints(double radius, Random random, double angle)
    {
        var points = new List<Vector3D>();
        for (double at = 0; ; at += (5 + (7 * random.NextDouble())) / Math.Abs(radius))
        {
            double place = Math.Min(at, angle) * Math.Sign(radius);
            points.Add(Middle + new Vector3D(Math.Abs(radius) * Math.Cos(place), Math.Abs(radius) * Math.Sin(place), 0));
            if (at >= angle)
            {
                return points;
            }
        }
    }

    private static RoadNetwork Truncated(IEnumerable<Vector3D> points) =>
        Road(points.Select(point => PathGrid.RemoveBias(PathGrid.Truncate(point))));

    private static RoadNetwork Road(IEnumerable<Vector3D> points)
    {
        RoadNode[] nodes = [.. points.Select((point, i) => new RoadNode(0, i, point, "", RoadNodeFlags.None))];
        return new RoadNetwork(
            nodes,
            [.. Enumerable.Range(0, nodes.Length - 1).Select(i => new RoadLink(i, i + 1, 2, 1, null, RoadLinkFlags.None))]
        );
    }

    private static void ForEachPoint(RoadCurves curves, double offset, Action<Vector3D> visit)
    {
        for (int link = 0; link < curves.Network.Links.Count; link++)
        {
            for (int step = 0; step < 20; step++)
            {
                visit(curves.Of(link).PointBeside((step + 0.5) / 20, offset));
            }
        }
    }

    private static double Square(double value) => value * value;
}
