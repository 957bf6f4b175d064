using Harvester.Geometry.Calibration;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Calibration;

public sealed class MarkerPlanTests
{
    private const double Radius = 6;

    [Fact]
    public void Across_puts_the_markers_in_a_grid_three_radii_from_the_edges()
    {
        MarkerPlan plan = MarkerPlan.Across(Camera(50, Lens.Ideal), 3, 2, Radius, [1]);

        // Columns at 18, 400, 782; rows at 18 and 582. Spacing: min(382, 564).
        Assert.Equal(
            [new(18, 18), new(400, 18), new(782, 18), new(18, 582), new(400, 582), new(782, 582)],
            plan.Markers.Select(marker => marker.ExpectedPixel));
        Assert.Equal(382, plan.SpacingPixels);
    }

    [Fact]
    public void Across_puts_each_marker_where_the_camera_sees_its_pixel_at_its_depth()
    {
        Camera camera = Camera(90, new Lens(1.01, 0.002, -0.003, -0.03, 0.004));

        MarkerPlan plan = MarkerPlan.Across(camera, 9, 7, Radius, [1, 2, 4]);

        Assert.All(plan.Markers, (marker, i) =>
        {
            Projection seen = camera.Project(marker.Centre);
            Assert.Equal(marker.ExpectedPixel.X, seen.U, 1e-9);
            Assert.Equal(marker.ExpectedPixel.Y, seen.V, 1e-9);
            Assert.Equal(new double[] { 1, 2, 4 }[((i % 9) + (i / 9)) % 3], seen.Depth, 1e-12);
        });
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
            new CameraIntrinsics(fov, new ImageSize(800, 600), 4.0 / 3, 0.1, lens));
}
