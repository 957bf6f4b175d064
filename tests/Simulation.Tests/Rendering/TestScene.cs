using Harvester.Geometry;
using Harvester.Simulation.Rendering;

namespace Harvester.Simulation.Tests.Rendering;

/// <summary>Cameras, shapes and seeded scenes that the rendering tests share.</summary>
internal static class TestScene
{
    public const int Width = 320;
    public const int Height = 240;
    public static readonly Rgb White = new(255, 255, 255);

    /// <summary>At the origin, looking north.</summary>
    public static RenderCamera Camera { get; } =
        new(new Pose(Vector3D.Zero, Axes.Identity), 90, (double)Width / Height, 0.1, Width, Height);

    public static RenderTarget Render(RenderScene scene, RenderCamera camera)
    {
        var target = new RenderTarget(camera.Width, camera.Height);
        new Renderer().Render(scene, camera, target);
        return target;
    }

    public static RenderTarget Render(RenderCamera camera, params MeshInstance[] instances)
    {
        var scene = new RenderScene([]);
        scene.SetDynamic(instances);
        return Render(scene, camera);
    }

    public static MeshInstance AtOrigin(Mesh mesh, int handle) => new(mesh, new Pose(Vector3D.Zero, Axes.Identity), handle);

    /// <summary>Ground, buildings of the world, and turned boxes and tubes with handles, all about the origin.</summary>
    public static RenderScene Seeded(int seed)
    {
        var random = new Random(seed);
        double Between(double low, double high) => low + ((high - low) * random.NextDouble());
        Mesh ground = new MeshBuilder()
            .AddQuad(new(-300, -300, -1.5), new(300, -300, -1.5), new(300, 300, -1.5), new(-300, 300, -1.5), White, Surface.Ground)
            .Build();
        var world = new List<MeshInstance> { AtOrigin(ground, 0) };
        var entities = new List<MeshInstance>();
        for (int i = 0; i < 40; i++)
        {
            var size = new Vector3D(Between(0.3, 4), Between(0.3, 4), Between(0.3, 4));
            var builder = new MeshBuilder()
                .AddBox(-size, size, White)
                .AddCylinder(new(0, 0, size.Z), new(0, 0, size.Z + 2), size.X * 0.4, 0.1, 9, White);
            var position = new Vector3D(Between(-60, 60), Between(6, 90), Between(-2, 5));
            var axes = Axes.FromEuler(new EulerAngles(Between(-30, 30), Between(-30, 30), Between(0, 360)));
            (i % 4 == 0 ? world : entities).Add(new MeshInstance(builder.Build(), new Pose(position, axes), i % 4 == 0 ? 0 : i));
        }

        var scene = new RenderScene(world);
        scene.SetDynamic(entities);
        return scene;
    }

    public static RenderCamera SeededCamera(int seed)
    {
        var random = new Random(seed);
        var angles = new EulerAngles((random.NextDouble() * 10) - 5, (random.NextDouble() * 10) - 5, (random.NextDouble() * 30) - 15);
        return Camera with
        {
            Pose = new Pose(new Vector3D(random.NextDouble(), random.NextDouble(), random.NextDouble()), Axes.FromEuler(angles)),
            VerticalFovDegrees = 50,
        };
    }
}
