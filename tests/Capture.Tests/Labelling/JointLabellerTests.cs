using Harvester.Capture.Harvesting;
using Harvester.Capture.Labelling;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>A person 10 m ahead whose joints lie on a line, before rays that meet what a test says.</summary>
public sealed class JointLabellerTests
{
    private const int Handle = 20;
    private const int Ego = 7;

    private static readonly HarvestOptions Options = new() { Image = new ImageSize(100, 100) };

    private static readonly EntityState Person = new(
        Handle,
        ObjectClass.Pedestrian,
        "person",
        new Pose(new Vector3D(0, 10, 0), Axes.Identity),
        new Vector3D(-0.3, -0.3, -1),
        new Vector3D(0.3, 0.3, 1),
        Vector3D.Zero
    )
    {
        Skeleton = new Skeleton(Enumerable.Range(0, Skeleton.Count).Select(joint => new Vector3D(0, 10, 1 - (joint / 11.0)))),
    };

    [Fact]
    public void Joints_have_the_pixels_of_their_positions()
    {
        JointsLabel joints = Label(Options, Person, (_, _) => null).Objects[0].Joints!;

        // 50 pixels a metre at a depth of 1 m: the crown is 1 m above the middle at 10 m, 5 pixels.
        Assert.Equal(45, joints[Joint.HeadTop].Pixel!.Value.Y, 9);
        Assert.Equal(50, joints[Joint.HeadTop].Pixel!.Value.X, 9);
        Assert.Equal(Person.Skeleton!.Joints, joints.Joints.Select(joint => joint.Position));
        Assert.True(joints.Box!.Value.YMin < 45);
    }

    [Theory]
    [InlineData(0, 10, JointVisibility.Visible)]
    [InlineData(Handle, 9.95, JointVisibility.Visible)]
    [InlineData(Handle, 9.5, JointVisibility.SelfOccluded)]
    [InlineData(Handle + 1, 9.95, JointVisibility.Occluded)]
    [InlineData(RayHit.World, 2, JointVisibility.Occluded)]
    public void Visibility_is_what_a_ray_meets_first(int entity, double distance, JointVisibility expected)
    {
        RayHit? hit = entity == 0 && distance >= 10 ? null : new RayHit(distance, entity);

        // All joints are exactly 10 m away.
        FrameDraft label = Label(Options, Person with { Skeleton = AllAt(new Vector3D(0, 10, 0)) }, (_, _) => hit);

        Assert.All(label.Objects[0].Joints!.Joints, joint => Assert.Equal(expected, joint.Visibility));
        Assert.Equal(Skeleton.Count, label.Rays!.Joints);
    }

    [Fact]
    public void Joints_outside_the_image_need_no_ray()
    {
        Vector3D[] places = [.. Person.Skeleton!.Joints];
        (places[0], places[1]) = (new Vector3D(0, -1, 0), new Vector3D(40, 10, 0));
        FrameDraft label = Label(Options, Person with { Skeleton = new Skeleton(places) }, (_, _) => null);

        JointsLabel joints = label.Objects[0].Joints!;
        Assert.Equal((null, JointVisibility.Outside), (joints.Joints[0].Pixel, joints.Joints[0].Visibility));
        Assert.Equal(250, joints.Joints[1].Pixel!.Value.X, 9);
        Assert.Equal(JointVisibility.Outside, joints.Joints[1].Visibility);
        Assert.Null(joints.Box);
        Assert.Equal(Skeleton.Count - 2, label.Rays!.Joints);
    }

    [Fact]
    public void Joints_without_rays_are_of_unknown_visibility()
    {
        JointsLabel joints = Label(Options with { RayBudget = 0 }, Person, (_, _) => null).Objects[0].Joints!;

        Assert.All(joints.Joints, joint => Assert.Equal(JointVisibility.Unknown, joint.Visibility));
        Assert.NotNull(joints.Box);
    }

    [Fact]
    public void Joints_beyond_the_reach_of_rays_are_of_unknown_visibility()
    {
        // The person's cuboid begins within reach.
        JointsLabel joints = Label(Options with { RayReachMetres = 9.9 }, Person, (_, _) => null).Objects[0].Joints!;

        Assert.All(joints.Joints, joint => Assert.Equal(JointVisibility.Unknown, joint.Visibility));
    }

    [Fact]
    public void Others_have_no_joints() => Assert.Null(Label(Options, Person with { Skeleton = null }, (_, _) => null).Objects[0].Joints);

    private static Skeleton AllAt(Vector3D place) => new(Enumerable.Repeat(place, Skeleton.Count));

    /// <summary>Labels a person; the rays of all phases but that of joints meet the person.</summary>
    private static FrameDraft Label(HarvestOptions options, EntityState person, Func<Ray, double, RayHit?> cast)
    {
        var snapshot = new SceneSnapshot(
            1,
            0,
            new CameraState(new Pose(Vector3D.Zero, Axes.Identity), 90, 0.15, 1),
            new EgoState(Ego, "ego", new Pose(new Vector3D(0, -3, 0), Axes.Identity), Vector3D.Zero),
            [person],
            new EnvironmentState("clear", TimeSpan.Zero)
        );
        var rays = new FrameRays(new JointRays(cast), options.RayBudget);
        var labeller = new FrameLabeller(options, rays, new ObjectRegistry(1));
        return labeller.LabelAtOnce(snapshot, static () => true);
    }

    /// <summary>Rays for joints end at them, those for silhouettes do not.</summary>
    private sealed class JointRays(Func<Ray, double, RayHit?> cast) : IRayCaster
    {
        public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity) =>
            maxDistance < 10.2 && ignoredEntity == Ego ? cast(ray, maxDistance) : new RayHit(9.7, Handle);
    }
}
