using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Calibration;

public sealed class MarkerPlanTests
{
    private const double Radius = 6;

    [Fact]
    public void Across_puts_markers_near_a_grid_three_radii_from_the_edges()
    {
        MarkerPlan plan = MarkerPlan.Across(Camera(50, Lens.Ideal), 3, 2, Radius, [1]);

        // Columns at 18, 400, 782; rows at 18 and 582. Neighbours are min(382, 564) apart, and may each lie 3 pixels towards the other.
        Vector2D[] grid = [new(18, 18), new(400, 18), new(782, 18), new(18, 582), new(400, 582), new(782, 582)];
        Assert.Equal(grid.Length, plan.Markers.Count);
        Assert.All(
            plan.Markers.Zip(grid),
            pair =>
            {
                Assert.InRange(pair.First.ExpectedPixel.X - pair.Second.X, -Radius / 2, Radius / 2);
                Assert.InRange(pair.First.ExpectedPixel.Y - pair.Second.Y, -Radius / 2, Radius / 2);
            }
        );
        Assert.Equal(376, plan.SpacingPixels);
    }

    [Fact]
    public void Across_spreads_markers_evenly_over_subpixel_positions()
    {
        MarkerPlan plan = MarkerPlan.Across(Camera(50, Lens.Ideal), 15, 11, Radius, [1]);

        // 165 markers over four quarters of a pixel: 41 each, give or take a dozen.
        int[] quarters =
        [
            .. plan
                .Markers.GroupBy(marker => (int)(4 * (marker.ExpectedPixel.X - Math.Floor(marker.ExpectedPixel.X))))
                .OrderBy(group => group.Key)
                .Select(group => group.Count()),
        ];
        Assert.Equal(4, quarters.Length);
        Assert.All(quarters, count => Assert.InRange(count, 29, 53));
    }

    [Theory]
    [InlineData(50)]
    [InlineData(90)]
    public void CentreOfImage_is_seen_in_the_middle_of_the_outline(double fov)
    {
        Camera camera = Camera(fov, Lens.Ideal);

        foreach (PlannedMarker marker in MarkerPlan.Across(camera, 5, 4, 30, [1, 2]).Markers)
        {
            // The ellipse is symmetrical about the line from the image's middle; its ends there are seen at θ ± asin(radius / distance).
            Vector3D local = camera.Pose.ToLocal(marker.Centre);
            double theta = Math.Atan2(Math.Sqrt((local.X * local.X) + (local.Z * local.Z)), local.Y);
            double half = Math.Asin(marker.RadiusMetres / local.Length);
            double middle = camera.Intrinsics.Fy * (Math.Tan(theta + half) + Math.Tan(theta - half)) / 2;
            Vector2D seen = camera.Project(marker.CentreOfImage(camera.Pose)).Pixel;
            Assert.Equal(middle, (seen - new Vector2D(400, 300)).Length, 1e-9);
        }
    }

    [Fact]
    public void Across_puts_each_marker_where_its_pixel_and_depth_say()
    {
        Camera camera = Camera(90, new Lens(1.01, 0.002, -0.003, -0.03, 0.004));

        MarkerPlan plan = MarkerPlan.Across(camera, 9, 7, Radius, [1, 2, 4]);

        Assert.All(
            plan.Markers,
            (marker, i) =>
            {
                Projection seen = camera.Project(marker.Centre);
                Assert.Equal(marker.ExpectedPixel.X, seen.U, 1e-9);
                Assert.Equal(marker.ExpectedPixel.Y, seen.V, 1e-9);
                Assert.Equal(new double[] { 1, 2, 4 }[((i % 9) + (i / 9)) % 3], seen.Depth, 1e-12);
            }
        );
    }

    [Theory]
    [InlineData(50)]
    [InlineData(90)]
    public void Across_makes_every_marker_look_alike(double fov)
    {
        Camera camera = Camera(fov, Lens.Ideal);

        foreach (PlannedMarker marker in MarkerPlan.Across(camera, 9, 7, Radius, [1, 2]).Markers)
        {
            // The outline along the radius: rays in the plane of axis and centre that touch the ball, at θ ± asin(radius / distance).
            Vector3D local = camera.Pose.ToLocal(marker.Centre);
            double theta = Math.Atan2(Math.Sqrt((local.X * local.X) + (local.Z * local.Z)), local.Y);
            double half = Math.Asin(marker.RadiusMetres / local.Length);
            double seen = camera.Intrinsics.Fy * (Math.Tan(theta + half) - Math.Tan(theta - half)) / 2;
            Assert.Equal(Radius, seen, 0.01 * Radius);
        }
    }

    [Fact]
    public void Across_refuses_a_grid_that_does_not_fit()
    {
        Camera camera = Camera(50, Lens.Ideal);

        Assert.Throws<ArgumentException>(() => MarkerPlan.Across(camera, 60, 7, Radius, [1]));
        Assert.Throws<ArgumentException>(() => MarkerPlan.Across(camera, 1, 7, Radius, [1]));
        Assert.Throws<ArgumentException>(() => MarkerPlan.Across(camera, 9, 7, Radius, []));
        Assert.Throws<ArgumentOutOfRangeException>(() => MarkerPlan.Across(camera, 9, 7, 0, [1]));
        Assert.Throws<ArgumentOutOfRangeException>(() => MarkerPlan.Across(camera, 9, 7, Radius, [-1]));
    }

    private static Camera Camera(double fov, Lens lens) =>
        new(
            new Pose(new Vector3D(100, 200, 30), Axes.FromEuler(new EulerAngles(5, -2, 140))),
            new CameraIntrinsics(fov, new ImageSize(800, 600), 4.0 / 3, 0.1, lens)
        );
}
