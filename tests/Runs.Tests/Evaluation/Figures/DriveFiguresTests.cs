using Harvester.Geometry;
using Harvester.Runs.Evaluation.Figures;

namespace Harvester.Runs.Tests.Evaluation.Figures;

public sealed class DriveFiguresTests
{
    [Fact]
    public void Of_counts_distance_and_time_by_driver()
    {
        DriveSample[] samples =
        [
            Drives.At(0),
            Drives.At(1),
            Drives.At(2) with
            {
                Lane = null,
            },
            Drives.At(3) with
            {
                IsByController = false,
            },
            Drives.At(50) with
            {
                IsTeleported = true,
            },
            Drives.At(51),
        ];
        DriveFigures figures = DriveFigures.Of(samples);

        // A metre each sample, except for the leap to sample 50.
        Assert.Equal(4, figures.Metres);
        Assert.Equal(0.4, figures.Seconds);
        Assert.Equal(3, figures.ControllerMetres);
        Assert.Equal(2, figures.JudgedMetres);
        Assert.Equal(10, figures.ControllerMeanSpeed);
        Assert.Equal(1, figures.Relocations);
    }

    [Fact]
    public void Of_lateral_error_is_the_root_of_the_mean_square()
    {
        DriveFigures figures = DriveFigures.Of(Drives.Of(0.3, -0.4));

        // √((0.09 + 0.16) / 2) = 0.3536.
        Assert.Equal(0.3536, figures.RmsLateralError);
        Assert.Equal(0.4, figures.LargestLateralError);
    }

    [Fact]
    public void Of_jerk_is_the_change_of_acceleration()
    {
        double[] speeds = [10, 10, 10.1, 10.1];
        DriveSample[] samples = [.. speeds.Select((speed, i) => Drives.At(i) with { Speed = speed })];

        // Accelerations 0, 1, 0 m/s² a tenth of a second apart: jerks 10 and -10 m/s³.
        Assert.Equal(10, DriveFigures.Of(samples).RmsJerk);
    }

    [Fact]
    public void Long_contact_with_a_vehicle_is_one_collision()
    {
        DriveSample[] samples =
        [
            Drives.At(0) with
            {
                Touching = [4],
            },
            Drives.At(1) with
            {
                Touching = [4, 5],
            },
            Drives.At(2),
            Drives.At(3) with
            {
                Touching = [4],
                Lane = null,
            },
            Drives.At(4) with
            {
                Touching = [6],
                IsByController = false,
            },
            Drives.At(5) with
            {
                Touching = [7, 8],
                IsByController = false,
                Lane = null,
            },
        ];
        DriveFigures figures = DriveFigures.Of(samples);

        Assert.Equal(2, figures.Collisions);
        Assert.Equal(1, figures.CollisionsInJunctions);
        Assert.Equal(1, figures.CollisionsOfOwnDriver);
        Assert.Equal(2, figures.CollisionsOfOwnDriverInJunctions);
        Assert.Contains(("collisions", "2 outside junctions, 1 inside; built-in driver: 1 outside junctions, 2 inside"), figures.Rows());
    }

    [Theory]
    [InlineData(0, 4.4, 0, true)]
    [InlineData(0, 4.6, 0, false)]
    [InlineData(1.9, 0, 0, true)]
    [InlineData(2.1, 0, 0, false)]
    [InlineData(3.1, 0, 90, true)]
    [InlineData(3.3, 0, 90, false)]
    [InlineData(2.3, 2.3, 45, true)]
    [InlineData(2.4, 2.4, 45, false)]
    public void Overlaps_boxes_of_two_by_four_and_a_half_metres(double right, double ahead, double turned, bool expected)
    {
        GroundBox one = Box(0, 0, 0, 0);
        GroundBox other = Box(right, ahead, turned, 0);

        // Along: 2.25 + 2.25; across: 1 + 1; at right angles across: 1 + 2.25. Turned by 45 degrees to the left, the second's
        // side parts them: on its normal (1, 1)·√½ the first reaches (1 + 2.25)·√½ = 2.298 m and it itself 1 m; 3.298 m are 2 · 2.332 m on
        // the axes.
        Assert.Equal(expected, one.Overlaps(other));
        Assert.Equal(expected, other.Overlaps(one));
        Assert.False(one.Overlaps(Box(right, ahead, turned, 5)));
    }

    private static GroundBox Box(double x, double y, double headingDegrees, double bottom)
    {
        (double sin, double cos) = Math.SinCos(Angles.ToRadians(headingDegrees));
        return new GroundBox(new Vector2D(x, y), new Vector2D(-sin, cos), 2.25, 1, bottom, bottom + 1.5);
    }
}
