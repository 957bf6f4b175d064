using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.People;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;
using Harvester.Simulation.Tests.Rendering;
using Harvester.TestSupport;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.People;

/// <summary>The joints of labels against the people that the renderer draws.</summary>
[Trait("Category", "Heavy")]
public sealed class JointLabelTests(ITestOutputHelper output)
{
    private const int Width = 800;
    private const int Height = 600;

    /// <summary>The seed with which radii and depths of joints were chosen.</summary>
    private const int DevelopmentSeed = 7;

    /// <summary>A seed that had no part in any choice.</summary>
    private const int OtherSeed = 90210;

    /// <summary>The oracle's picture is so much finer, because a far limb is narrower than a pixel.</summary>
    private const int Finer = 4;

    /// <summary>The required distance of a labelled joint from the drawn one.</summary>
    private const double MaxPixels = 0.5;

    /// <summary>The required F1 of visible joints.</summary>
    private const double MinF1 = 0.98;

    /// <summary>The required mean IoU of the joints' box with the box of the drawn silhouette.</summary>
    private const double MinIoU = 0.85;

    /// <summary>Radius of a drawn marker, in pixels of the fine picture: its centroid is then known to a small part of one.</summary>
    private const double MarkerPixels = 5;

    /// <summary>Of the joints of a person, one in this many gets a marker.</summary>
    private const int Every = 4;

    public static TheoryData<int> Seeds => [.. ProofSize.Of([OtherSeed], [DevelopmentSeed, OtherSeed])];

    [Theory]
    [MemberData(nameof(Seeds))]
    public void Joints_are_where_markers_are_drawn(int seed)
    {
        int compared = 0;
        double greatest = 0;
        Harvest(
            seed,
            frames: 6,
            (label, game, drawn) =>
            {
                Camera camera = label.Camera.ToCamera();
                foreach ((ObjectLabel person, int handle) in People(label, game).Take(3))
                {
                    // A part of the joints of each, in turn, because each marker is a picture.
                    MeshInstance whole = drawn.Whole(handle);
                    for (int joint = person.Id % Every; joint < Skeleton.Count; joint += Every)
                    {
                        JointLabel labelled = person.Joints!.Joints[joint];
                        double radius = MarkerPixels * (labelled.Position - camera.Pose.Position).Length / (camera.Intrinsics.Fy * Finer);
                        Vector3D local = whole.Pose.ToLocal(drawn.SkeletonOf(handle).Joints[joint]);
                        Mesh ball = new MeshBuilder()
                            .AddEllipsoid(local, new Vector3D(radius, radius, radius), 12, 12, TestScene.White)
                            .Build();
                        if (
                            labelled.Visibility != JointVisibility.Outside
                            && Centroid(drawn.DrawAlone(new MeshInstance(ball, whole.Pose, 1))) is { } centre
                        )
                        {
                            compared++;
                            greatest = Math.Max(greatest, (centre - labelled.Pixel!.Value).Length);
                        }
                    }
                }
            }
        );
        output.WriteLine($"{compared} joints, greatest distance {greatest:F3} px");
        Assert.True(compared > 50, $"Only {compared} joints.");
        Assert.True(greatest <= MaxPixels, $"A joint is {greatest:F3} px from its marker.");
    }

    [Fact]
    public void Limbs_are_drawn_around_their_joints()
    {
        int compared = 0,
            within = 0;
        Harvest(
            DevelopmentSeed,
            frames: 6,
            (label, game, drawn) =>
            {
                foreach ((ObjectLabel person, int handle) in People(label, game).Where(each => each.Person.Box2D.Height > 40).Take(3))
                {
                    foreach (BodyPart part in Enum.GetValues<BodyPart>())
                    {
                        RenderTarget alone = drawn.DrawAlone(drawn.PartOf(handle, part));
                        foreach (Joint joint in JointParts.LimbsOf(part))
                        {
                            if (person.Joints![joint] is { Pixel: { } pixel, Visibility: not JointVisibility.Outside })
                            {
                                compared++;
                                within += IsDrawnAt(alone, pixel) ? 1 : 0;
                            }
                        }
                    }
                }
            }
        );
        output.WriteLine($"{within} of {compared} joints lie within the drawn limbs that they join");
        Assert.True(compared > 60, $"Only {compared} joints.");
        Assert.Equal(compared, within);
    }

    /// <summary>One figure for both towns; in one alone it varies by some thousandths.</summary>
    [Fact]
    public void Visible_joints_are_those_that_the_renderer_shows()
    {
        var table = new int[5, 5];
        Array.ForEach(
            [DevelopmentSeed, OtherSeed],
            seed =>
                Harvest(
                    seed,
                    frames: 30,
                    (label, game, drawn) =>
                    {
                        foreach ((ObjectLabel person, int handle) in People(label, game))
                        {
                            for (int joint = 0; joint < Skeleton.Count; joint++)
                            {
                                JointLabel labelled = person.Joints!.Joints[joint];
                                if (labelled.Visibility != JointVisibility.Outside)
                                {
                                    table[(int)TruthOf(drawn, label, (Joint)joint, labelled, handle), (int)labelled.Visibility]++;
                                }
                            }
                        }
                    }
                )
        );
        const int visible = (int)JointVisibility.Visible;
        int found = Enumerable.Range(0, 5).Sum(truth => table[truth, visible]);
        int shown = Enumerable.Range(0, 5).Sum(labelled => table[visible, labelled]);
        double f1 = 2.0 * table[visible, visible] / (found + shown);
        foreach (JointVisibility truth in Enum.GetValues<JointVisibility>())
        {
            IEnumerable<string> counts = Enum.GetValues<JointVisibility>().Select(each => $"{each} {table[(int)truth, (int)each]}");
            output.WriteLine($"{truth}: " + string.Join(", ", counts));
        }

        output.WriteLine($"F1 of visible joints {f1:F4}");
        Assert.True(shown > 1000, $"Only {shown} visible joints.");
        Assert.True(f1 >= MinF1, $"F1 is {f1:F4}.");
    }

    [Theory]
    [MemberData(nameof(Seeds))]
    public void Box_of_joints_is_that_of_the_silhouette(int seed)
    {
        List<double> joints = [];
        List<double> cuboids = [];
        Harvest(
            seed,
            frames: 30,
            (label, game, drawn) =>
            {
                foreach (
                    (ObjectLabel person, int handle) in People(label, game)
                        .Where(each => each.Person is { TruncatedFraction: 0, OccludedFraction: 0 })
                )
                {
                    RenderTarget alone = drawn.DrawAlone(drawn.Whole(handle));
                    if (Silhouette.BoxOf(alone, handle) is { } fine)
                    {
                        Box2D box = new(fine.XMin / Finer, fine.YMin / Finer, fine.XMax / Finer, fine.YMax / Finer);
                        joints.Add(person.Joints!.Box!.Value.IntersectionOverUnion(box));
                        cuboids.Add(person.Box2DAmodal.IntersectionOverUnion(box));
                    }
                }
            }
        );
        output.WriteLine(
            $"{joints.Count} people: mean IoU {joints.Average():F3} of the joints' box, {cuboids.Average():F3} of the cuboid's"
        );
        Assert.True(joints.Count > 50, $"Only {joints.Count} people.");
        Assert.True(joints.Average() >= MinIoU, $"The mean IoU is {joints.Average():F3}.");
    }

    private static void Harvest(int seed, int frames, Action<FrameLabel, SimulatedGame, PeopleInParts> judge)
    {
        var game = new SimulatedGame(
            new SimulationOptions
            {
                Seed = seed,
                PedestrianDensity = 4,
                TrafficDensity = 1,
                WindowAspect = 4 / 3.0,
            }
        );
        var options = new HarvestOptions
        {
            Image = new ImageSize(Width, Height),
            MaxFrames = frames,
            RateHz = 0.5,
            RangeMetres = 80,
        };
        LabelledTown.Harvest(
            game,
            game.Ports,
            options,
            (frame, _) => judge(frame.Label, game, new PeopleInParts(game, Width, Height, Finer))
        );
    }

    /// <summary>The labelled people with the handles of their entities, found by place and not by joints.</summary>
    private static IEnumerable<(ObjectLabel Person, int Handle)> People(FrameLabel label, SimulatedGame game) =>
        from person in label.Objects
        where person.Class == ObjectClass.Pedestrian
        select (
            person,
            game.Shown.Entities.MinBy(entity =>
                (entity.Pose.ToWorld((entity.ModelMin + entity.ModelMax) * 0.5) - person.Box3D.Centre).Length
            )!.Handle
        );

    /// <summary>
    /// What the picture shows at a joint: a part that the joint belongs to, another part of the person, something else, or what lies
    /// behind the joint.
    /// </summary>
    private static JointVisibility TruthOf(PeopleInParts drawn, FrameLabel label, Joint joint, JointLabel labelled, int handle)
    {
        Vector2D pixel = labelled.Pixel!.Value;
        int at = ((int)(pixel.Y * Finer) * drawn.Picture.Width) + (int)(pixel.X * Finer);
        double depth = label.Camera.Pose.ToLocal(labelled.Position).Y;
        (int Handle, BodyPart Part)? shown = PeopleInParts.Read(drawn.Picture.Handles[at]);
        return drawn.Picture.Depth[at] >= depth ? JointVisibility.Visible
            : shown is not { } body || body.Handle != handle ? JointVisibility.Occluded
            : JointParts.Of(joint).Contains(body.Part) && IsOnOwnSide(drawn, label, joint, handle, pixel, drawn.Picture.Depth[at])
                ? JointVisibility.Visible
            : JointVisibility.SelfOccluded;
    }

    /// <summary>Whether what is seen is nearer to a joint than to its like on the other side, which the trunk may lie between.</summary>
    private static bool IsOnOwnSide(PeopleInParts drawn, FrameLabel label, Joint joint, int handle, Vector2D pixel, double depth)
    {
        Skeleton skeleton = drawn.SkeletonOf(handle);
        Vector3D seen = label.Camera.ToCamera().Unproject(pixel.X, pixel.Y, depth);
        return JointParts.Other(joint) is not { } other || (seen - skeleton[joint]).Length < (seen - skeleton[other]).Length;
    }

    /// <summary>Whether something is drawn at a pixel or one beside it: a joint lies on the border where two parts meet.</summary>
    private static bool IsDrawnAt(RenderTarget picture, Vector2D pixel) =>
        (
            from row in Enumerable.Range((int)(pixel.Y * Finer) - 1, 3)
            from column in Enumerable.Range((int)(pixel.X * Finer) - 1, 3)
            where row >= 0 && row < picture.Height && column >= 0 && column < picture.Width
            select picture.Handles[(row * picture.Width) + column]
        ).Any(number => number != 0);

    private static Vector2D? Centroid(RenderTarget picture)
    {
        int[] pixels = [.. Enumerable.Range(0, picture.Handles.Length).Where(pixel => picture.Handles[pixel] != 0)];
        bool isCut = pixels.Any(pixel =>
            pixel % picture.Width is 0
            || pixel % picture.Width == picture.Width - 1
            || pixel / picture.Width is 0
            || pixel / picture.Width == picture.Height - 1
        );
        return pixels.Length == 0 || isCut
            ? null
            : new Vector2D(
                (pixels.Average(pixel => pixel % picture.Width) + 0.5) / Finer,
                (pixels.Average(pixel => pixel / picture.Width) + 0.5) / Finer
            );
    }
}
