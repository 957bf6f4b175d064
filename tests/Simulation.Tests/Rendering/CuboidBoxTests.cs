using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Algorithm 1 against the oracle: boxes of cuboids and the silhouettes that the renderer draws of them.</summary>
public sealed class CuboidBoxTests
{
    /// <summary>The required accuracy of each side of a box.</summary>
    private const double PixelTolerance = 1;

    /// <summary>
    /// The oracle draws this many times finer: a silhouette is known by the centres of the pixels that it covers, and one that ends in
    /// a sharp corner covers none near its tip.
    /// </summary>
    private const int Finer = 4;

    /// <summary>Slivers of a silhouette with fewer fine pixels are hardly more than such a tip.</summary>
    private const int MinPixels = 150 * Finer * Finer;
    private const int Attempts = 4;

    private static readonly Vector3D Min = new(-1, -2.2, -0.4);
    private static readonly Vector3D Max = new(1, 2.4, 1.1);

    public static TheoryData<int, string> Cases()
    {
        var cases = new TheoryData<int, string>();
        for (int seed = 1; seed <= 10; seed++)
        {
            cases.Add(seed, "free");
            cases.Add(seed, "edge");
            cases.Add(seed, "near");
            cases.Add(seed, "bent");
        }

        return cases;
    }

    [Theory]
    [MemberData(nameof(Cases))]
    [Trait("Category", "Heavy")]
    public void Project_agrees_with_the_rendered_silhouette(int seed, string place)
    {
        var random = new Random(seed);
        Mesh box = new MeshBuilder().AddBox(Min, Max, TestScene.White).Build();
        int compared = 0;
        for (int attempt = 0; attempt < Attempts; attempt++)
        {
            RenderCamera camera = CameraOf(random, place);
            Pose pose = PoseOf(random, place);
            RenderTarget target = TestScene.Render(
                camera with
                {
                    Width = camera.Width * Finer,
                    Height = camera.Height * Finer,
                },
                new MeshInstance(box, pose, 1)
            );
            CuboidProjection projection = CuboidProjector.Project(Analytic(camera), Cuboid.FromModel(Min, Max, pose));
            int pixels = Silhouette.Count(target, 1);
            if (pixels < MinPixels)
            {
                Assert.True(pixels == 0 || projection.Box is not null, "Something is drawn where the box says there is nothing.");
                continue;
            }

            compared++;
            Box2D drawn = Silhouette.BoxOf(target, 1)!.Value;
            Assert.NotNull(projection.Box);
            AssertSidesAgree(
                projection,
                new Box2D(drawn.XMin / Finer, drawn.YMin / Finer, drawn.XMax / Finer, drawn.YMax / Finer),
                $"seed {seed}, {place}, attempt {attempt}"
            );
        }

        Assert.True(compared >= 1, $"Only {compared} of {Attempts} silhouettes were large enough.");
    }

    [Fact]
    public void Project_of_a_cuboid_around_the_camera_is_the_whole_image()
    {
        // The near plane cuts the box open, yet every ray that leaves the camera hits its far sides.
        Mesh box = new MeshBuilder().AddBox(new(-3, -3, -3), new(3, 3, 3), TestScene.White).Build();
        RenderTarget target = TestScene.Render(TestScene.Camera, TestScene.AtOrigin(box, 1));
        var cuboid = Cuboid.FromModel(new(-3, -3, -3), new(3, 3, 3), new Pose(Vector3D.Zero, Axes.Identity));

        Assert.Equal(target.Handles.Length, Silhouette.Count(target, 1));
        Assert.Equal(new Box2D(0, 0, TestScene.Width, TestScene.Height), CuboidProjector.Project(Analytic(TestScene.Camera), cuboid).Box);
    }

    internal static Camera Analytic(RenderCamera camera) =>
        new(
            camera.Pose,
            new CameraIntrinsics(
                camera.VerticalFovDegrees,
                new ImageSize(camera.Width, camera.Height),
                camera.WindowAspect,
                camera.NearClip,
                new Lens(camera.Lens.FocalScale, camera.Lens.CentreOffsetX, camera.Lens.CentreOffsetY, camera.Lens.K1, camera.Lens.K2)
            )
        );

    private static RenderCamera CameraOf(Random random, string place)
    {
        RenderCamera camera = TestScene.Camera with
        {
            Width = 200,
            Height = 150,
            Pose = new Pose(
                new Vector3D(1000, -3000, 20),
                Axes.FromEuler(new EulerAngles((random.NextDouble() * 20) - 10, (random.NextDouble() * 20) - 10, 0))
            ),
            VerticalFovDegrees = 40 + (random.NextDouble() * 40),
            WindowAspect = place == "free" ? 16.0 / 9 : 4.0 / 3,
            NearClip = place == "near" ? 0.5 : 0.15,
        };
        return place == "bent" ? camera with { Lens = new RenderLens(1.02, 0.01, -0.01, -0.15, 0.02) } : camera;
    }

    private static Pose PoseOf(Random random, string place)
    {
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        (double right, double ahead) = place switch
        {
            "edge" => (Between(0.5, 0.9) * (random.Next(2) == 0 ? -1 : 1), Between(6, 15)),
            "near" => (Between(-0.5, 0.5), Between(0.8, 3)),
            _ => (Between(-0.2, 0.2), Between(7, 30)),
        };
        double below = place == "near" ? Between(-3, -1.5) : Between(-2, 0);
        var position = new Vector3D(1000 + (right * ahead), -3000 + ahead, 20 + below);
        return new Pose(position, Axes.FromEuler(new EulerAngles(Between(-10, 10), Between(-10, 10), Between(0, 360))));
    }

    private static void AssertSidesAgree(CuboidProjection projection, Box2D drawn, string what)
    {
        Box2D box = projection.Box!.Value;
        Assert.True(
            Math.Abs(box.XMin - drawn.XMin) <= PixelTolerance
                && Math.Abs(box.YMin - drawn.YMin) <= PixelTolerance
                && Math.Abs(box.XMax - drawn.XMax) <= PixelTolerance
                && Math.Abs(box.YMax - drawn.YMax) <= PixelTolerance,
            $"{what}: box {box}, drawn {drawn}"
        );
    }
}
