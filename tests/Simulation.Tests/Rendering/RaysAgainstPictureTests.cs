using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Geometry's rays through pixel centres, cast at the scene, against the picture that matrices and z-buffer make of it.</summary>
public sealed class RaysAgainstPictureTests
{
    /// <summary>A centre that lies on a silhouette's edge to within rounding may fall either way.</summary>
    private const double ShareOnSilhouettes = 0.001;

    /// <summary>Single precision of the stored depth, relative.</summary>
    private const double DepthTolerance = 1e-5;

    [Theory]
    [InlineData(1, 0, 0)]
    [InlineData(2, 0, 0)]
    [InlineData(3, 0, 0)]
    [InlineData(4, -0.25, 0.05)]
    [InlineData(5, 0.2, 0.02)]
    public void Cast_through_a_pixel_centre_hits_what_the_pixel_shows(int seed, double k1, double k2)
    {
        RenderScene scene = TestScene.Seeded(seed);
        RenderCamera camera = TestScene.SeededCamera(seed) with { Lens = new RenderLens(0.97, 0.01, -0.02, k1, k2) };
        RenderTarget target = TestScene.Render(scene, camera);
        var rays = new SceneRayCaster(scene);
        var analytic = new Camera(
            camera.Pose,
            new CameraIntrinsics(
                camera.VerticalFovDegrees,
                new ImageSize(camera.Width, camera.Height),
                camera.WindowAspect,
                camera.NearClip,
                new Lens(0.97, 0.01, -0.02, k1, k2)
            )
        );

        int mismatches = 0;
        for (int pixel = 0; pixel < target.Handles.Length; pixel++)
        {
            Ray ray = analytic.RayThrough((pixel % camera.Width) + 0.5, (pixel / camera.Width) + 0.5);
            RayHit? hit = rays.Cast(ray, 10_000, RayHit.World);
            double depth = hit is { } met ? met.Distance * ray.Direction.Dot(camera.Pose.Axes.Forward) : double.PositiveInfinity;
            bool sameDepth = double.IsInfinity(depth)
                ? float.IsInfinity(target.Depth[pixel])
                : Math.Abs(depth - target.Depth[pixel]) <= depth * DepthTolerance;
            mismatches += sameDepth && (hit?.Entity ?? 0) == target.Handles[pixel] ? 0 : 1;
        }

        Assert.True(target.Handles.Distinct().Count() > 5, "The scene has too few entities in view to show anything.");
        Assert.InRange(mismatches, 0, target.Handles.Length * ShareOnSilhouettes);
    }

    [Fact]
    public void Cast_passes_through_the_ignored_entity_and_ends_at_max_range()
    {
        Mesh box = new MeshBuilder().AddBox(new(-1, -1, -1), new(1, 1, 1), TestScene.White).Build();
        var scene = new RenderScene([]);
        scene.SetDynamic([new(box, new Pose(new(0, 10, 0), Axes.Identity), 1), new(box, new Pose(new(0, 20, 0), Axes.Identity), 2)]);
        var rays = new SceneRayCaster(scene);
        var north = new Ray(Vector3D.Zero, new Vector3D(0, 1, 0));

        // The faces towards the origin are at 9 and 19 m.
        Assert.Equal(new RayHit(9, 1), rays.Cast(north, 100, RayHit.World));
        Assert.Equal(new RayHit(19, 2), rays.Cast(north, 100, 1));
        Assert.Null(rays.Cast(north, 8.9, RayHit.World));
        Assert.Null(rays.Cast(north, 18.9, 1));
    }

    [Theory]
    [InlineData(1, 0)]
    [InlineData(-1, 0)]
    [InlineData(0, 1)]
    [InlineData(0, -1)]
    [InlineData(1, 1)]
    public void Cast_along_a_face_hits_the_edge_it_starts_at(double x, double z)
    {
        Mesh box = new MeshBuilder().AddBox(new(-1, -1, -1), new(1, 1, 1), TestScene.White).Build();
        var scene = new RenderScene([new(box, new Pose(new(0, 10, 0), Axes.Identity), 0)]);

        Assert.Equal(
            new RayHit(9, RayHit.World),
            new SceneRayCaster(scene).Cast(new Ray(new(x, 0, z), new Vector3D(0, 1, 0)), 100, RayHit.World)
        );
    }

    [Fact]
    public void Cast_along_a_face_through_the_origin_hits_its_edge()
    {
        Mesh box = new MeshBuilder().AddBox(new(-1, -1, -1), new(0, 1, 1), TestScene.White).Build();
        var scene = new RenderScene([new(box, new Pose(new(0, 10, 0), Axes.Identity), 0)]);

        Assert.Equal(
            new RayHit(9, RayHit.World),
            new SceneRayCaster(scene).Cast(new Ray(new(0, 0, 0.5), new Vector3D(0, 1, 0)), 100, RayHit.World)
        );
    }

    [Fact]
    public void Cast_at_several_shapes_at_once_hits_the_first()
    {
        // All have a face at y = 9, but their boxes differ. Sizes and rays are such that nothing is rounded.
        MeshInstance[] boxes =
        [
            .. Enumerable
                .Range(1, 12)
                .Select(i => new MeshInstance(
                    new MeshBuilder().AddBox(new(-1 << i, 9, -1 << i), new(1 << i, 9 + (1 << i), 1 << i), TestScene.White).Build(),
                    new Pose(Vector3D.Zero, Axes.Identity),
                    i
                )),
        ];
        var scene = new RenderScene([]);
        scene.SetDynamic(boxes);
        var rays = new SceneRayCaster(scene);

        for (double x = -1; x <= 1; x += 0.125)
        {
            Assert.Equal(
                new RayHit(9, scene.Dynamic.Instances[0].Handle),
                rays.Cast(new Ray(new(x, 0, 0.25), new Vector3D(0, 1, 0)), 100, RayHit.World)
            );
        }
    }

    [Fact]
    public void Cast_hits_the_nearest_triangle()
    {
        // Against every triangle of the scene tried one by one.
        RenderScene scene = TestScene.Seeded(6);
        var rays = new SceneRayCaster(scene);
        var random = new Random(6);
        for (int i = 0; i < 300; i++)
        {
            var ray = new Ray(
                new(random.NextDouble() * 20, random.NextDouble() * 20, 3),
                new(random.NextDouble() - 0.5, random.NextDouble(), random.NextDouble() - 0.5)
            );
            double nearest = double.PositiveInfinity;
            foreach (MeshInstance instance in scene.Static.Instances.ToArray().Concat(scene.Dynamic.Instances.ToArray()))
            {
                foreach (MeshTriangle t in instance.Mesh.Triangles.ToArray())
                {
                    nearest = Math.Min(
                        nearest,
                        Distance(ray, instance.Pose.ToWorld(t.A), instance.Pose.ToWorld(t.B), instance.Pose.ToWorld(t.C))
                    );
                }
            }

            double found = rays.Cast(ray, 1_000, RayHit.World)?.Distance ?? double.PositiveInfinity;
            Assert.True(
                nearest > 1_000 ? double.IsInfinity(found) : Math.Abs(found - nearest) < 1e-9 * nearest + 1e-9,
                $"ray {i}: {found} instead of {nearest}"
            );
        }
    }

    /// <summary>Cramer's rule for origin + t d = a + u (b - a) + v (c - a); infinity for a miss.</summary>
    private static double Distance(Ray ray, Vector3D a, Vector3D b, Vector3D c)
    {
        Vector3D normal = (b - a).Cross(c - a);
        double t = (a - ray.Origin).Dot(normal) / ray.Direction.Dot(normal);
        Vector3D at = ray.At(t);
        bool isInside =
            (b - a).Cross(at - a).Dot(normal) >= 0 && (c - b).Cross(at - b).Dot(normal) >= 0 && (a - c).Cross(at - c).Dot(normal) >= 0;
        return isInside && t >= 0 ? t : double.PositiveInfinity;
    }
}
