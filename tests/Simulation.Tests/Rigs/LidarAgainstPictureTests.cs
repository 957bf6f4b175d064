using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Points of a LiDAR compared with the depth and the entities that the renderer draws, which shares no code with rays.</summary>
public sealed class LidarAgainstPictureTests
{
    /// <summary>The requirement: a point lies within 2 cm of the surface that the renderer shows.</summary>
    private const double DepthMetres = 0.02;

    [Theory]
    [InlineData(3)]
    [InlineData(64)]
    [InlineData(65)]
    [Trait("Category", "Heavy")]
    public void Points_are_within_2_cm_of_the_rendered_depth(int seed)
    {
        var place = new Vector3D(0, 0.5, 1.6);
        Rig rig = new(
            "test",
            Vector3D.Zero,
            [RigHarvest.Camera("front", place, 0, new ImageSize(1600, 1200))],
            [new RigLidar("top", new Pose(place, Axes.Identity), [2, 0, -2, -5, -9, -14, -20], 720, 10, 0.5, 60)]
        );
        var moment = new RigHarvest(rig, seed);
        LidarSweep sweep = Assert.Single(moment.Frames[0].Part<SweptPoints>()!.Sweeps);
        RenderTarget picture = moment.Game.Render(rig.Cameras[0].Image);
        CameraLabel label = moment.Frames[0].Label.Camera;
        Camera camera = label.ToCamera();

        int compared = 0;
        int onObjects = 0;
        foreach (LidarPoint point in sweep.Points)
        {
            // The LiDAR stands where the camera does and looks the same way, so its frame is the camera's.
            var local = new Vector3D(point.X, point.Y, point.Z);
            Projection seen = camera.Project(camera.Pose.ToWorld(local));
            if (seen.Outcome != ProjectionOutcome.InImage || DepthAt(picture, seen.U, seen.V) is not { } depth)
            {
                continue;
            }

            Assert.InRange(point.Y - depth, -DepthMetres, DepthMetres);
            int handle = picture.Handles[((int)seen.V * picture.Width) + (int)seen.U];
            Assert.True(handle != 0 || point.ObjectId == 0, "A point on the world has the id of an object.");
            compared++;
            onObjects += point.ObjectId != 0 ? 1 : 0;
        }

        // The sector of the camera is a sixth of the turn, and most of what it shows is smooth.
        Assert.InRange(compared, sweep.Points.Count / 20, sweep.Points.Count);
        Assert.NotEqual(0, onObjects);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Beams_and_columns_are_where_the_rig_says()
    {
        double[] beams = [0, -10, -30];
        Rig rig = new(
            "test",
            Vector3D.Zero,
            [RigHarvest.Camera("front", new Vector3D(0, 2, 0.4), 0, new ImageSize(64, 48))],
            [new RigLidar("top", new Pose(new Vector3D(0, 0, 1.6), Axes.Identity), beams, 8, 10, 0.5, 60)]
        );

        LidarSweep sweep = new RigHarvest(rig, seed: 3).Frames[0].Part<SweptPoints>()!.Sweeps[0];

        Assert.Equal(24, sweep.RaysCast);
        foreach (LidarPoint point in sweep.Points)
        {
            // Column c of 8 is at 45 · c - 180 degrees clockwise from ahead.
            double azimuth = Math.Atan2(point.X, point.Y) * 180 / Math.PI;
            double turned = Math.IEEERemainder(azimuth - ((45 * point.Column) - 180), 360);
            double elevation = Math.Atan2(point.Z, Math.Sqrt((point.X * point.X) + (point.Y * point.Y))) * 180 / Math.PI;

            // Single precision keeps seven digits.
            const double rounding = 1e-4;
            Assert.InRange(turned, -rounding, rounding);
            Assert.InRange(elevation - beams[point.Beam], -rounding, rounding);
        }

        // The steepest beam meets the road 1.8 m below all around.
        Assert.Equal(8, sweep.Points.Count(point => point.Beam == 2));
    }

    [Fact]
    public void Car_is_not_hit_by_its_own_lidar()
    {
        // A sensor on the bonnet looks down at 80 degrees: past the car there is only the road, 0.65 m below.
        Rig rig = new(
            "test",
            Vector3D.Zero,
            [RigHarvest.Camera("front", new Vector3D(0, 2, 0.4), 0, new ImageSize(64, 48))],
            [new RigLidar("top", new Pose(new Vector3D(0, 2, 0.4), Axes.Identity), [-80], 8, 10, 0.1, 60)]
        );

        LidarSweep sweep = new RigHarvest(rig, seed: 3).Frames[0].Part<SweptPoints>()!.Sweeps[0];

        Assert.Equal(8, sweep.Points.Count);
        Assert.All(sweep.Points, point => Assert.InRange(point.Z, -0.8, -0.5));
    }

    /// <summary>
    /// The depth at a place of the picture, between the four pixel centres around it; null unless all pixels near show one smooth surface.
    /// </summary>
    private static double? DepthAt(RenderTarget picture, double u, double v)
    {
        int column = (int)Math.Floor(u - 0.5);
        int row = (int)Math.Floor(v - 0.5);
        if (column < 1 || row < 1 || column + 2 >= picture.Width || row + 2 >= picture.Height)
        {
            return null;
        }

        // Depth is the inverse of a linear function over the plane of a surface: its second differences vanish.
        double Inverse(int x, int y) => 1 / picture.Depth[(y * picture.Width) + x];
        const double smooth = 1e-6;
        for (int y = row; y <= row + 1; y++)
        {
            for (int x = column; x <= column + 1; x++)
            {
                double across = Inverse(x - 1, y) - (2 * Inverse(x, y)) + Inverse(x + 1, y);
                double along = Inverse(x, y - 1) - (2 * Inverse(x, y)) + Inverse(x, y + 1);
                if (!(Math.Abs(across) <= smooth && Math.Abs(along) <= smooth))
                {
                    return null;
                }
            }
        }

        double right = u - 0.5 - column;
        double down = v - 0.5 - row;
        double inverse =
            (Inverse(column, row) * (1 - right) * (1 - down))
            + (Inverse(column + 1, row) * right * (1 - down))
            + (Inverse(column, row + 1) * (1 - right) * down)
            + (Inverse(column + 1, row + 1) * right * down);
        return inverse > 0 ? 1 / inverse : null;
    }
}
