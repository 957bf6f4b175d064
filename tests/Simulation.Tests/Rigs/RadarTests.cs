using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Scenes;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>Detections of a radar compared with the places and velocities that the scene of the same frame records.</summary>
public sealed class RadarTests
{
    /// <summary>The requirement: without noise, the radial velocity is the projected relative velocity.</summary>
    private const double VelocityTolerance = 1e-6;

    /// <summary>Bodies are a little larger than the boxes of their models where mirrors and limbs stick out.</summary>
    private const double BoxTolerance = 0.3;

    private static readonly Pose Mount = new(new Vector3D(0.2, 2.2, 0.4), Axes.FromEuler(new EulerAngles(0.02, 0.01, 0.1)));

    [Theory]
    [InlineData(9301)]
    [InlineData(9302)]
    [InlineData(9303)]
    [Trait("Category", "Heavy")]
    public void Radial_velocity_is_the_projected_relative_velocity(int seed)
    {
        CapturedFrame frame = Moment(seed, Exact());
        (IReadOnlyList<RadarDetection> detections, RecordedScene scene) = Of(frame);
        Dictionary<int, EntityState> entities = EntitiesOf(scene);
        EgoState ego = scene.Snapshot.Ego;
        Vector3D place = ego.Pose.ToWorld(Mount.Position);
        Vector3D arm = place - ego.Pose.Position;
        double turning = ego.Motion!.YawRate;
        var carried = new Vector3D(ego.Velocity.X - (turning * arm.Y), ego.Velocity.Y + (turning * arm.X), ego.Velocity.Z);

        int onObjects = 0;
        foreach (RadarDetection detection in detections)
        {
            Vector3D line = ego.Pose.Axes.ToWorld(Mount.Axes.ToWorld(DirectionOf(detection)));
            Vector3D velocity = detection.Object == 0 ? Vector3D.Zero : entities[detection.Object].Velocity;
            if (detection.Object == 0 && detection.GroundVelocity != 0)
            {
                continue;
            }

            Assert.Equal((velocity - carried).Dot(line), detection.RadialVelocity, VelocityTolerance);
            Assert.Equal(velocity.Dot(line), detection.GroundVelocity, VelocityTolerance);
            onObjects += detection.Object != 0 ? 1 : 0;
        }

        Assert.NotEqual(0, onObjects);
        Assert.Contains(detections, detection => detection.Object == 0);
        Assert.All(detections, detection => Assert.Equal(RadarOrigin.Target, detection.Origin));
        Assert.Equal(detections.Select(detection => detection.Range).Order(), detections.Select(detection => detection.Range));
    }

    [Theory]
    [InlineData(9301)]
    [InlineData(9302)]
    [Trait("Category", "Heavy")]
    public void Detections_of_objects_are_on_their_boxes(int seed)
    {
        (IReadOnlyList<RadarDetection> detections, RecordedScene scene) = Of(Moment(seed, Exact()));
        Dictionary<int, EntityState> entities = EntitiesOf(scene);
        Pose sensor = scene.Snapshot.Ego.Pose.Compose(Mount);
        foreach (RadarDetection detection in detections.Where(detection => detection.Object != 0))
        {
            EntityState entity = entities[detection.Object];
            Vector3D local = entity.Pose.ToLocal(sensor.ToWorld(DirectionOf(detection) * detection.Range));
            var grown = new Vector3D(BoxTolerance, BoxTolerance, BoxTolerance);
            Assert.True(IsAbove(local, entity.ModelMin - grown) && IsAbove(entity.ModelMax + grown, local), $"{local} is outside its box.");
        }
    }

    /// <summary>The cross-section of an object near the radar, all of whose cells are detected, is that of its class and aspect.</summary>
    [Theory]
    [InlineData(9301)]
    [InlineData(9302)]
    [Trait("Category", "Heavy")]
    public void Cross_sections_of_a_car_add_up_to_that_of_its_aspect(int seed)
    {
        const double near = 30;
        (IReadOnlyList<RadarDetection> detections, RecordedScene scene) = Of(Moment(seed, Exact() with { MaxDetections = 1000 }));
        Dictionary<int, EntityState> entities = EntitiesOf(scene);
        Vector3D place = scene.Snapshot.Ego.Pose.ToWorld(Mount.Position);
        int compared = 0;
        foreach (
            IGrouping<int, RadarDetection> own in detections
                .Where(detection => detection.Object != 0)
                .GroupBy(detection => detection.Object)
                .Where(own => own.All(detection => detection.Range < near))
        )
        {
            EntityState entity = entities[own.Key];
            if (entity.Class != ObjectClass.Car)
            {
                continue;
            }

            Vector3D towards = entity.Pose.ToLocal(place);
            double cosine = Math.Cos(2 * Math.Atan2(towards.X, towards.Y));
            double squareMetres = own.Sum(detection => Math.Pow(10, detection.CrossSection / 10));
            Assert.Equal(20 * (0.1 + (0.9 * cosine * cosine)), squareMetres, 1e-6);
            compared++;
        }

        Assert.NotEqual(0, compared);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Errors_leave_the_others_as_they_are()
    {
        (IReadOnlyList<RadarDetection> exact, _) = Of(Moment(9304, Exact() with { MaxDetections = 1000 }));
        (IReadOnlyList<RadarDetection> cluttered, _) = Of(
            Moment(9304, Exact() with { MaxDetections = 1000, Clutter = 20, GhostFraction = 1 })
        );
        RadarDetection[] ghosts = [.. cluttered.Where(detection => detection.Origin == RadarOrigin.Ghost)];

        Assert.Equal(exact, cluttered.Where(detection => detection.Origin == RadarOrigin.Target));
        Assert.Contains(cluttered, detection => detection.Origin == RadarOrigin.Clutter);
        Assert.NotEmpty(ghosts);
        Assert.All(
            ghosts,
            ghost =>
                Assert.Contains(
                    exact,
                    target =>
                        2 * target.Range == ghost.Range
                        && 2 * target.RadialVelocity == ghost.RadialVelocity
                        && target.AzimuthDegrees == ghost.AzimuthDegrees
                )
        );
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Range_decides_what_is_detected()
    {
        (IReadOnlyList<RadarDetection> far, _) = Of(Moment(9305, Exact()));
        (IReadOnlyList<RadarDetection> near, _) = Of(Moment(9305, Exact() with { RangeMetres = 40 }));

        Assert.True(near.Count < far.Count);
        Assert.All(near, detection => Assert.InRange(detection.Range, 0, 40));

        // σ ≥ 10 m² (R / 40 m)⁴, rounded in neither.
        Assert.All(
            near,
            detection => Assert.True(Math.Pow(10, detection.CrossSection / 10) * (1 + 1e-9) >= 10 * Math.Pow(detection.Range / 40, 4))
        );
    }

    /// <summary>The objects of a scene by their ids.</summary>
    private static Dictionary<int, EntityState> EntitiesOf(RecordedScene scene) =>
        scene.Snapshot.Entities.Where(entity => scene.Ids.ContainsKey(entity.Handle)).ToDictionary(entity => scene.Ids[entity.Handle]);

    private static RigRadar Exact() => new("ahead", Mount, 120, 20, 150) { MaxDetections = 300 };

    private static CapturedFrame Moment(int seed, RigRadar radar)
    {
        Rig rig = new("test", Vector3D.Zero, [RigHarvest.Camera("front", new Vector3D(0, 2, 0.4), 0, new ImageSize(64, 48))], [])
        {
            Radars = [radar],
        };
        return new RigHarvest(rig, seed, new HarvestOptions { RangeMetres = 200 }).Frames[0];
    }

    private static (IReadOnlyList<RadarDetection> Detections, RecordedScene Scene) Of(CapturedFrame frame) =>
        (Assert.Single(frame.Label.Channels.Get<RadarsLabel>()!.Scans).Detections, frame.Scene!);

    private static Vector3D DirectionOf(RadarDetection detection)
    {
        double azimuth = detection.AzimuthDegrees * Math.PI / 180;
        double elevation = detection.ElevationDegrees * Math.PI / 180;
        return new Vector3D(-Math.Cos(elevation) * Math.Sin(azimuth), Math.Cos(elevation) * Math.Cos(azimuth), Math.Sin(elevation));
    }

    private static bool IsAbove(Vector3D a, Vector3D b) => a.X >= b.X && a.Y >= b.Y && a.Z >= b.Z;
}
