using Harvester.Driving.Scenarios;
using Harvester.Geometry;

namespace Harvester.Driving.Tests.Scenarios;

public class LaneTrackTests
{
    private static readonly LaneTrack Bent = new([new(0, 0, 0), new(0, 10, 1), new(10, 10, 1)], -5);

    [Fact]
    public void Distances_begin_where_they_are_said_to()
    {
        Assert.Equal(-5, Bent.From);
        Assert.Equal(15, Bent.To, 9);
        Assert.Equal(new Vector3D(0, 5, 0.5), Bent.PositionAt(0));
    }

    [Fact]
    public void Place_is_located_along_and_to_the_right()
    {
        (double at, double right) = Bent.Locate(new Vector3D(6, 8, 0));

        Assert.Equal(11, at, 9);
        Assert.Equal(2, right, 9);
        Assert.Equal(new Vector3D(6, 8, 1), Bent.Beside(at, right));
    }

    [Fact]
    public void Ends_are_prolonged()
    {
        (double at, double right) = Bent.Locate(new Vector3D(-3, -7, 0));

        Assert.Equal(-12, at, 9);
        Assert.Equal(-3, right, 9);
    }

    [Fact]
    public void Reversed_track_keeps_its_zero_and_swaps_sides()
    {
        LaneTrack back = Bent.Reversed();

        Assert.Equal(Bent.PositionAt(3), back.PositionAt(-3));
        Assert.Equal(-2, back.Locate(new Vector3D(6, 8, 0)).Right, 9);
    }

    [Fact]
    public void Path_runs_from_one_distance_to_another_beside_the_track()
    {
        IReadOnlyList<Vector3D> path = Bent.Path(0, 4, _ => 1);

        Assert.Equal(new Vector3D(1, 5, 0.5), path[0]);
        Assert.Equal(new Vector3D(1, 9, 0.9).X, path[^1].X, 9);
    }
}
