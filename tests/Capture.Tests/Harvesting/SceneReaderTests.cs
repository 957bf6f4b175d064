using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Harvesting;

public sealed class SceneReaderTests : IWorld
{
    private static readonly Pose Ahead = new(new Vector3D(0, 3, 4), Axes.Identity);
    private double _range;

    public long GameFrame => 0;

    public double TimeSeconds => 0;

    public CameraState ReadCamera() => new(new Pose(Vector3D.Zero, Axes.Identity), 50, 1.5, 0.1);

    public EgoState ReadEgo() => new(1, "car", new Pose(Vector3D.Zero, Axes.Identity), Vector3D.Zero);

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range)
    {
        _range = range;
        return [];
    }

    public EnvironmentState ReadEnvironment() => new("clear", TimeSpan.Zero);

    // The camera and the LiDAR are 5 m from the car's origin; objects are labelled up to 100 m from the camera.
    [Theory]
    [InlineData(null, 105)]
    [InlineData(60, 105)]
    [InlineData(400, 405)]
    public void Objects_are_read_as_far_as_camera_and_lidar_see(int? lidarMetres, double range)
    {
        var camera = new RigCamera("front", Ahead, 50, new ImageSize(64, 48), Lens.Ideal);
        RigLidar[] lidars = lidarMetres is { } metres ? [new RigLidar("top", Ahead, [0], 4, 10, 0.5, metres)] : [];
        var options = new HarvestOptions
        {
            RangeMetres = 100,
            IgnoreRangeMetres = 0,
            Rig = new Rig("test", Vector3D.Zero, [camera], lidars),
        };
        new SceneReader(this, options).Read();

        const double rounding = 1e-9;
        Assert.Equal(range, _range, rounding);
    }
}
