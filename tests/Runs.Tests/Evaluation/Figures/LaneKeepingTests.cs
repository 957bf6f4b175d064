using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Tests.Evaluation.Figures;

public sealed class LaneKeepingTests
{
    [Fact]
    public void Departures_car_within_its_lane_has_none()
    {
        // The side reaches 1.6 + 1 = 2.6 m; the marking is at 2.7 m.
        Assert.Empty(new LaneKeeping(Drives.Of(0, 1.6, -1.6, 0)).Departures);
    }

    [Fact]
    public void Departures_beyond_the_edge_count_once_until_the_car_is_back()
    {
        Assert.Equal([1, 4], new LaneKeeping(Drives.Of(0, 1.8, 1.9, 0, -1.8, 0)).Departures);
    }

    [Fact]
    public void Departures_beside_all_lanes_counts()
    {
        Assert.Equal([1], new LaneKeeping([Drives.At(0), Drives.At(1, lane: null), Drives.At(2)]).Departures);
    }

    [Fact]
    public void Crossing_that_ends_in_the_next_lane_is_a_lane_change()
    {
        var keeping = new LaneKeeping([Drives.At(0, 0, 0, 2), Drives.At(1, 2, 0, 2), Drives.At(2, -2, 1, 2), Drives.At(3, 0, 1, 2)]);

        Assert.Empty(keeping.Departures);
        Assert.Equal(1, keeping.Changes);
    }

    [Fact]
    public void Crossing_that_comes_back_is_a_departure()
    {
        var keeping = new LaneKeeping([Drives.At(0, 0, 0, 2), Drives.At(1, 2, 0, 2), Drives.At(2, 0, 0, 2)]);

        Assert.Equal([1], keeping.Departures);
        Assert.Equal(0, keeping.Changes);
    }

    [Fact]
    public void Crossing_that_ends_in_a_junction_is_neither()
    {
        var keeping = new LaneKeeping([
            Drives.At(0, 0, 0, 2),
            Drives.At(1, 2, 0, 2),
            Drives.At(2) with
            {
                Lane = null,
            },
            Drives.At(3, 0, 0, 2),
        ]);

        Assert.Empty(keeping.Departures);
        Assert.Equal(0, keeping.Changes);
    }

    [Fact]
    public void Departures_of_built_in_driver_or_in_junctions_are_ignored()
    {
        DriveSample[] samples =
        [
            Drives.At(0),
            Drives.At(1, 2) with
            {
                IsByController = false,
            },
            Drives.At(2) with
            {
                Lane = null,
            },
            Drives.At(3),
        ];

        Assert.Empty(new LaneKeeping(samples).Departures);
    }

    [Fact]
    public void LateralErrors_skip_four_seconds_around_a_lane_change()
    {
        // A change of lane at 10.1 and 10.2 s of 30 s: the samples from 6.2 to 14.1 s are left out.
        DriveSample[] samples =
        [
            .. Enumerable.Range(0, 101).Select(i => Drives.At(i, 0.1, 0, 2)),
            Drives.At(101, 2, 0, 2),
            Drives.At(102, -2, 1, 2),
            .. Enumerable.Range(103, 198).Select(i => Drives.At(i, 0.1, 1, 2)),
        ];
        double[] errors = [.. new LaneKeeping(samples).LateralErrors()];

        Assert.All(errors, error => Assert.Equal(0.1, error));
        Assert.Equal(301 - 80, errors.Length, 1.0);
    }
}
