using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Sessions.Faces;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests.Games;

/// <summary>
/// A world as far as the game's API lets one see it: poses, dimensions and velocities in single precision, the camera's orientation as
/// angles, time in whole milliseconds, and no names of people. Both sides of a comparison look at this same world, so that
/// what is compared is the mod and not the precision of the API.
/// </summary>
internal sealed class SinglePrecisionWorld(IWorld world, FaceTable faces) : IWorld
{
    private const double BeyondAll = 1e6;

    /// <summary>The mod reads no joints farther from the camera, metres.</summary>
    private const double JointRange = 100;

    public long GameFrame => world.GameFrame;

    public double TimeSeconds => Milliseconds * 0.001;

    public int Milliseconds => (int)Math.Round(world.TimeSeconds * 1000);

    public CameraState ReadCamera()
    {
        CameraState camera = world.ReadCamera();
        EulerAngles angles = camera.Pose.Axes.ToEuler();
        var rounded = new EulerAngles((float)angles.PitchDegrees, (float)angles.RollDegrees, (float)angles.YawDegrees);
        return new CameraState(
            new Pose(Round(camera.Pose.Position), Axes.FromEuler(rounded)),
            (float)camera.VerticalFovDegrees,
            (float)camera.NearClip,
            (float)camera.WindowAspect
        );
    }

    public EgoState ReadEgo()
    {
        EgoState ego = world.ReadEgo();
        return ego with
        {
            Pose = Round(ego.Pose),
            Velocity = Round(ego.Velocity),
            HeightAboveGroundMetres = (float?)ego.HeightAboveGroundMetres,
        };
    }

    public IReadOnlyList<EntityState> ReadEntities(Vector3D centre, double range) =>
        Unrounded()
            .Select(entity =>
                entity with
                {
                    Pose = Round(entity.Pose),
                    ModelMin = Round(entity.ModelMin),
                    ModelMax = Round(entity.ModelMax),
                    Velocity = Round(entity.Velocity),
                    Skeleton = (Round(entity.Pose).Position - centre).Length < JointRange ? Round(entity.Skeleton) : null,
                }
            )
            .Where(entity => (entity.Pose.Position - centre).Length < range)
            .ToArray();

    public EnvironmentState ReadEnvironment()
    {
        EnvironmentState environment = world.ReadEnvironment();
        return environment with { TimeOfDay = TimeSpan.FromSeconds(Math.Floor(environment.TimeOfDay.TotalSeconds)) };
    }

    /// <summary>Everything that the mod reads, before it is rounded: vehicles, people, and the props of the table.</summary>
    public IEnumerable<EntityState> Unrounded() =>
        world
            .ReadEntities(default, BeyondAll)
            .Where(entity => entity.Class < ObjectClass.Sign || entity.Class == ObjectClass.Rider || faces.Of(entity.Model).Count > 0)
            .Select(entity =>
                VehicleClasses.ArePeople(entity.Class) ? entity with { Model = $"0x{ModelHash.Of(entity.Model):X8}" } : entity
            );

    public static Vector3D Round(Vector3D vector) => new((float)vector.X, (float)vector.Y, (float)vector.Z);

    /// <summary>The game has no bone at the crown: it follows from the rounded bones of neck and head.</summary>
    private static Skeleton? Round(Skeleton? skeleton)
    {
        if (skeleton is null)
        {
            return null;
        }

        Vector3D[] joints = [.. skeleton.Joints.Select(Round)];
        joints[0] = joints[1] + (joints[1] - joints[2]);
        return new Skeleton(joints);
    }

    private static Pose Round(Pose pose) =>
        new(Round(pose.Position), Axes.FromVectors(Round(pose.Axes.Right), Round(pose.Axes.Forward), Round(pose.Axes.Up)));
}
