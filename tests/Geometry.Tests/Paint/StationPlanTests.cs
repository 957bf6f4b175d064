using Harvester.Geometry.Paint;
using Harvester.Geometry.Roads;

namespace Harvester.Geometry.Tests.Paint;

public sealed class StationPlanTests
{
    /// <summary>Shows 40 m of a road without the border, and 28 m across.</summary>
    private static readonly SurveyFootprint Footprint = new(42, 30);

    [Fact]
    public void Straight_road_has_a_station_for_each_footprint()
    {
        StationPlan plan = Of(Chain(links: 1, metres: 190, lanes: 1));

        Assert.Equal(5, plan.Stations.Count);
        Assert.Equal(190, plan.RoadMetres, 1.0);
        Assert.All(plan.Stations, station => Assert.Equal(0, station.HeadingDegrees, 6));
        Assert.All(plan.Stations, station => Assert.Equal(0, station.Ground.X, 6));
    }

    [Fact]
    public void Short_links_share_stations() => Assert.Equal(5, Of(Chain(links: 20, metres: 10, lanes: 1)).Stations.Count);

    [Fact]
    public void Wide_road_has_rows_of_stations_side_by_side()
    {
        StationPlan plan = Of(Chain(links: 1, metres: 190, lanes: 4));

        // 4 lanes of up to 6.5 m and a shoulder reach 27 m to each side: two strips of 27 m.
        Assert.Equal(10, plan.Stations.Count);
        Assert.Equal([-13.5, 13.5], plan.Stations.Select(station => Math.Round(station.Ground.X, 3)).Distinct().Order());
    }

    [Fact]
    public void Every_row_of_a_bent_road_is_shown()
    {
        RoadNetwork network = Bend();
        var roads = new PaintRoads(new RoadCurves(network));
        var plan = StationPlan.Of(roads, Footprint, null);

        for (int link = 0; link < network.Links.Count; link++)
        {
            for (int row = 0; row < roads.RowsOf(link); row++)
            {
                RoadCurve curve = roads.Curves.Of(link);
                Vector3D place = curve.PointAt(curve.ParameterAt(roads.StationOf(link, row)));
                Assert.Contains(plan.Stations, station => station.Shows(place, Footprint));
            }
        }
    }

    [Fact]
    public void Range_leaves_out_what_is_farther()
    {
        var plan = StationPlan.Of(Roads(Chain(links: 20, metres: 50, lanes: 1)), Footprint, new SurveyArea([new Vector2D(0, 500)], 100));

        Assert.Equal(200, plan.RoadMetres, 2.0);
        Assert.All(plan.Stations, station => Assert.InRange(station.Ground.Y, 380, 620));
    }

    [Fact]
    public void Survey_that_was_stopped_has_the_stations_that_are_left()
    {
        PaintRoads roads = Roads(Chain(links: 4, metres: 50, lanes: 1));
        IReadOnlyList<SurveyStation> all = StationPlan.Of(roads, Footprint, null).Stations;
        SurveyStation[] first = [.. all.Take(2)];

        Assert.Equal(all.Skip(2), StationPlan.Of(roads, Footprint, null, first).Stations);
        Assert.Empty(StationPlan.Of(roads, Footprint, null, [.. all]).Stations);
    }

    [Fact]
    public void Ring_of_links_without_a_length_is_left()
    {
        var network = new RoadNetwork(
            [Node(0, 0, 0), Node(1, 0, 40), Node(2, 0, 40)],
            [
                new RoadLink(0, 1, 1, 1, 0, RoadLinkFlags.None),
                new RoadLink(1, 2, 1, 1, 0, RoadLinkFlags.None),
                new RoadLink(2, 1, 1, 1, 0, RoadLinkFlags.None),
            ]
        );

        Assert.NotEmpty(Of(network).Stations);
    }

    [Fact]
    public void Network_without_roads_has_no_station() => Assert.Empty(Of(new RoadNetwork([], [])).Stations);

    [Theory]
    [InlineData(4, 30)]
    [InlineData(42, double.NaN)]
    public void Footprint_that_shows_no_road_is_refused(double along, double across) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new SurveyFootprint(along, across));

    private static StationPlan Of(RoadNetwork network) => StationPlan.Of(Roads(network), Footprint, null);

    private static PaintRoads Roads(RoadNetwork network) => new(new RoadCurves(network));

    /// <summary>A road to the north, of links of equal length and as many lanes in each direction.</summary>
    private static RoadNetwork Chain(int links, double metres, int lanes) =>
        new(
            [.. Enumerable.Range(0, links + 1).Select(i => Node(i, 0, i * metres))],
            [.. Enumerable.Range(0, links).Select(i => new RoadLink(i, i + 1, lanes, lanes, 0, RoadLinkFlags.None))]
        );

    /// <summary>A road on three quarters of a circle of 30 m.</summary>
    private static RoadNetwork Bend() =>
        new(
            [.. Enumerable.Range(0, 13).Select(i => Node(i, 30 * Math.Cos(i * Math.PI / 8), 30 * Math.Sin(i * Math.PI / 8)))],
            [.. Enumerable.Range(0, 12).Select(i => new RoadLink(i, i + 1, 1, 1, 0, RoadLinkFlags.None))]
        );

    private static RoadNode Node(int number, double x, double y) => new(0, number, new Vector3D(x, y, 0), string.Empty, RoadNodeFlags.None);
}
