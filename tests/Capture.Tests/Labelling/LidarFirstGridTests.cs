using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Geometry.Work;
using Harvester.Sessions.Lidar;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>A LiDAR with very few rays in the middle of a cube.</summary>
public sealed class LidarFirstGridTests : ISurfaceRays
{
    /// <summary>Half the side of the cube, metres.</summary>
    private const double Wall = 20;

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) => Cast(ray, maxDistance, ignoredEntity, out _);

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity, out Vector3D normal)
    {
        (Vector3D Axis, double Way)[] ways =
        [
            .. new[] { new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1) }
                .Where(axis => ray.Direction.Dot(axis) != 0)
                .Select(axis => (axis, ((Wall * Math.Sign(ray.Direction.Dot(axis))) - ray.Origin.Dot(axis)) / ray.Direction.Dot(axis))),
        ];
        (normal, double distance) = ways.MinBy(way => way.Way);
        return new RayHit(distance, RayHit.World);
    }

    [Fact]
    public void All_beams_have_points_though_the_fraction_is_tiny()
    {
        LidarModel model = LidarModel.Find("HDL-32E")!;
        var lidar = new RigLidar(
            "top",
            new Pose(Vector3D.Zero, Axes.Identity),
            model.BeamsDegrees,
            model.ColumnsAt(20),
            20,
            0.5,
            model.RangeMetres
        )
        {
            RayFraction = 0.01,
        };
        var ego = new EgoState(1, "car", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero);
        var moment = new SceneSnapshot(
            1,
            0,
            new CameraState(ego.Pose, 50, 1.5, 0.1),
            ego,
            [],
            new EnvironmentState("clear", TimeSpan.Zero)
        );
        var game = new GamePorts(null!, this, null!, null!, null!) { SurfaceRays = this };
        var result = new WorkResult<LidarSweep>();
        WorkRun.Complete(new LidarScanner(lidar, lidar.Mount, new LabellingOptions(), game, new ObjectRegistry(1)).Scan(moment, result));
        LidarSweep sweep = result.Value!;

        // Columns 0, 24, ..., 1080 and 1084, beams 0, 4, ..., 28 and 31; a hundredth of the 34,720 rays are only 347.
        const int corners = 47 * 9;
        Assert.InRange(sweep.RaysCast, corners, corners + 5);
        Assert.Equal(lidar.Rays, sweep.Points.Count);
    }
}
