using Harvester.Geometry;
using Harvester.Geometry.Roads;
using Harvester.Runs.Driving;

namespace Harvester.Cli.Tests.Driving;

public sealed class SeedRangeTests
{
    [Theory]
    [InlineData("701-703")]
    [InlineData("701..703")]
    public void Both_forms_include_both_ends(string text) => Assert.Equal([701, 702, 703], SeedRange.Parse(text)!.Value.All);

    [Theory]
    [InlineData("703-701")]
    [InlineData("1-1001")]
    [InlineData("-1-3")]
    [InlineData("7")]
    public void Other_forms_are_refused(string text) => Assert.Null(SeedRange.Parse(text));

    [Fact]
    public void Each_seed_drives_from_each_start()
    {
        DriveSettings plan = new()
        {
            Controller = new() { Kind = Harvester.Driving.Controllers.ControllerKind.Stanley },
            Seeds = [5, 6],
            Starts = [new(1, 2), new(3, 4)],
        };
        Assert.Equal([5, 5, 6, 6], plan.Episodes.Select(episode => episode.Seed));
        Assert.Equal([1.0, 3, 1, 3], plan.Episodes.Select(episode => episode.Start!.Value.X));
    }

    [Fact]
    public void Places_are_drawn_by_length_and_not_on_water()
    {
        // 900 m and 100 m of road, and as much water.
        RoadNode[] nodes =
        [
            Node(0, RoadNodeFlags.None),
            Node(900, RoadNodeFlags.None),
            Node(1000, RoadNodeFlags.None),
            Node(2000, RoadNodeFlags.Water),
        ];
        RoadNetwork roads = new(nodes, [Link(0, 1), Link(1, 2), Link(2, 3)]);
        IReadOnlyList<Vector2D> places = RandomPlaces.On(roads, 400, seed: 3);

        Assert.All(places, place => Assert.True(place.X is 450 or 950));
        Assert.InRange(places.Count(place => place.X == 450), 330, 390);
        Assert.Equal(places, RandomPlaces.On(roads, 400, seed: 3));

        static RoadNode Node(double x, RoadNodeFlags flags) => new(0, 0, new Vector3D(x, 0, 0), "", flags);
        static RoadLink Link(int from, int to) => new(from, to, 1, 1, null, RoadLinkFlags.None);
    }
}
