using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Jpeg;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Simulation.Game;
using Harvester.Simulation.Settings;

namespace Harvester.Benchmarks.Figures;

/// <summary>
/// The figures of docs/performance.md that need no command, one "name value" a line. It leaves a rendered frame and its instance map behind
/// as PNG files, so that bench/run can measure OpenCV on the same pictures.
/// </summary>
internal static class FigureRun
{
    private const int JpegQuality = 95;
    private const int Points = 100_000;
    private const int RayStep = 4;
    private const double RayReach = 300;
    private static readonly ImageSize Size = new(800, 600);

    public static void Run(string folder)
    {
        Projection();
        LabellingFigures.Run();
        MaskFigures.Run();
        RoadFigures.Run(folder);
        var game = new SimulatedGame(new SimulationOptions { Seed = 3 });
        for (int tick = 0; tick < 60; tick++)
        {
            game.Tick(1 / 60.0);
        }

        VoxelFigures.Run(game);
        FlowFigures.Run(game);
        Rays(game);
        var picture = new PixelBuffer(Size);
        game.Ports.Screen.Grab(picture);
        var map = new InstanceMap(Size);
        int[] handles = game.Render(Size).Handles;
        for (int i = 0; i < handles.Length; i++)
        {
            map.Ids[i] = (ushort)handles[i];
        }

        var png = new PngEncoder();
        var jpeg = new JpegEncoder(JpegQuality);
        Encoder("png", Path.Combine(folder, "frame.png"), file => png.Write(picture, file));
        Encoder("mask", Path.Combine(folder, "mask.png"), file => png.Write(map, file));
        Encoder("jpeg", Path.Combine(folder, "frame.jpg"), file => jpeg.Write(picture, file));
    }

    private static void Projection()
    {
        var random = new Random(1);
        var points = new Vector3D[Points];
        for (int i = 0; i < points.Length; i++)
        {
            points[i] = new Vector3D((20 * random.NextDouble()) - 10, 5 + (95 * random.NextDouble()), (10 * random.NextDouble()) - 5);
        }

        Camera camera = Camera();
        var projections = new Projection[Points];
        FigureLine.Write("projection.points_per_second", Points / Stopclock.BestSeconds(() => camera.ProjectAll(points, projections)));
    }

    private static void Rays(SimulatedGame game)
    {
        Camera camera = new(game.Shown.Camera.Pose, Camera().Intrinsics);
        List<Ray> rays = [];
        for (int row = 0; row < Size.Height; row += RayStep)
        {
            for (int column = 0; column < Size.Width; column += RayStep)
            {
                rays.Add(camera.RayThrough(column + 0.5, row + 0.5));
            }
        }

        FigureLine.Write(
            "rays.per_second",
            rays.Count
                / Stopclock.BestSeconds(() =>
                {
                    foreach (Ray ray in rays)
                    {
                        game.Ports.Rays.Cast(ray, RayReach, 0);
                    }
                })
        );
    }

    private static void Encoder(string name, string path, Action<Stream> write)
    {
        using var file = new MemoryStream(2_000_000);
        double seconds = Stopclock.BestSeconds(() =>
        {
            file.SetLength(0);
            write(file);
        });
        FigureLine.Write($"{name}.milliseconds", 1000 * seconds);
        FigureLine.Write($"{name}.bytes", file.Length);
        File.WriteAllBytes(path, file.ToArray());
    }

    private static Camera Camera() =>
        new(new Pose(Vector3D.Zero, Axes.Identity), new CameraIntrinsics(50, Size, Size.Aspect, 0.15, Lens.Ideal));
}
