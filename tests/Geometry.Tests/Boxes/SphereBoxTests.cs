using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests.Boxes;

/// <summary>Boxes of spheres against points on them.</summary>
public sealed class SphereBoxTests
{
    /// <summary>Points as dense as these come so near to the outline.</summary>
    private const double SamplingPixels = 0.02;

    /// <summary>With distortion the box is that of one point of each side.</summary>
    private const double DistortedPixels = 0.3;

    [Theory]
    [InlineData(0, SamplingPixels)]
    [InlineData(-0.05, DistortedPixels)]
    public void Around_is_the_box_of_the_points_of_spheres(double k1, double tolerance)
    {
        var camera = new Camera(
            new Pose(new Vector3D(1, 2, 3), Axes.FromHeading(30)),
            new CameraIntrinsics(50, new ImageSize(800, 600), 4 / 3.0, 0.15, new Lens(1, 0, 0, k1, 0))
        );
        Vector3D[] centres = [.. new Vector3D[] { new(0.3, 4, 0.2), new(-1, 6, 1), new(2, 5, -1.5) }.Select(camera.Pose.ToWorld)];
        double[] radii = [0.1, 0.2, 0.15];
        Box2D? points = null;
        for (int i = 0; i < centres.Length; i++)
        {
            for (double tilt = -90; tilt <= 90; tilt++)
            {
                for (double turn = 0; turn < 360; turn++)
                {
                    (double t, double u) = (Angles.ToRadians(tilt), Angles.ToRadians(turn));
                    Vector3D point =
                        centres[i] + (new Vector3D(Math.Cos(t) * Math.Cos(u), Math.Cos(t) * Math.Sin(u), Math.Sin(t)) * radii[i]);
                    Vector2D pixel = camera.Project(point).Pixel;
                    var own = new Box2D(pixel.X, pixel.Y, pixel.X, pixel.Y);
                    points = points?.Union(own) ?? own;
                }
            }
        }

        Box2D box = SphereBox.Around(camera, centres, radii)!.Value;

        Assert.Equal(points!.Value.XMin, box.XMin, tolerance);
        Assert.Equal(points.Value.YMin, box.YMin, tolerance);
        Assert.Equal(points.Value.XMax, box.XMax, tolerance);
        Assert.Equal(points.Value.YMax, box.YMax, tolerance);
    }

    [Theory]
    [InlineData(0.2, false)]
    [InlineData(0.3, true)]
    [InlineData(-3, false)]
    public void Around_a_sphere_at_the_near_plane_is_nothing(double depth, bool hasBox)
    {
        var camera = new Camera(
            new Pose(Vector3D.Zero, Axes.Identity),
            new CameraIntrinsics(50, new ImageSize(800, 600), 4 / 3.0, 0.15, Lens.Ideal)
        );

        Assert.Equal(hasBox, SphereBox.Around(camera, [new Vector3D(0, 9, 0), new Vector3D(0, depth, 0)], [0.1, 0.1]) is not null);
    }
}
