using Harvester.Capture.Harvesting;
using Harvester.Capture.Ports;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Imaging.Pictures;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Tests.Labelling;

namespace Harvester.Simulation.Tests;

/// <summary>What a frame costs on any machine may not grow: bytes written and allocated, triangles drawn and rays cast.</summary>
public class SimulationCostTests
{
    private const int WarmingTicks = 60;

    /// <summary>What OpenCV 4.6 writes of this frame at its level 1.</summary>
    private const long MaxBytesOfPicture = 209_720;

    private const int Ticks = 100;
    private const long MaxBytesPerTick = 160_000;
    private const int MaxTrianglesDrawn = 28_000;
    private const double RayLength = 10_000;
    private const int RayFrames = 3;
    private const int MaxRays = 6_000;
    private const int MaxRaysWithMask = 8_500;

    [Fact]
    public void Picture_of_a_street_has_few_bytes()
    {
        SimulatedGame game = Warm();
        var picture = new PixelBuffer(new ImageSize(800, 600));
        game.Ports.Screen.Grab(picture);
        using var file = new MemoryStream();
        new PngEncoder().Write(picture, file);
        Assert.InRange(file.Length, 1, MaxBytesOfPicture);
    }

    [Fact]
    public void Tick_allocates_little()
    {
        SimulatedGame game = Warm();
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int tick = 0; tick < Ticks; tick++)
        {
            game.Tick(1 / 60.0);
        }

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, Ticks * MaxBytesPerTick);
    }

    [Fact]
    public void Ray_allocates_nothing()
    {
        SimulatedGame game = Warm();
        var ahead = new Ray(game.Shown.Camera.Pose.Position, game.Shown.Camera.Pose.Axes.Forward);
        Assert.NotNull(game.Ports.Rays.Cast(ahead, RayLength, RayHit.World));
        long before = GC.GetAllocatedBytesForCurrentThread();
        game.Ports.Rays.Cast(ahead, RayLength, RayHit.World);
        Assert.Equal(0, GC.GetAllocatedBytesForCurrentThread() - before);
    }

    /// <summary>Of 260,000 triangles in view; 3,500 of them show. Without the tests against what is drawn it is 80,000.</summary>
    [Fact]
    public void Picture_draws_few_hidden_triangles()
    {
        SimulatedGame game = Warm();
        CameraState state = game.Shown.Camera;
        var renderer = new Renderer();
        var camera = new RenderCamera(state.Pose, state.VerticalFovDegrees, state.WindowAspect, state.NearClip, 800, 600);
        renderer.Render(game.ShapesForRays, camera, new RenderTarget(800, 600));
        Assert.InRange(renderer.TrianglesDrawn, 1, MaxTrianglesDrawn);
    }

    [Theory]
    [InlineData(false, MaxRays)]
    [InlineData(true, MaxRaysWithMask)]
    [Trait("Category", "Heavy")]
    public void Frame_takes_few_rays(bool masks, int most)
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 3 });
        GamePorts ports = game.Ports with { Roads = new FixedRoads(game.Roads, "simulation") };
        var options = new HarvestOptions
        {
            Image = new ImageSize(800, 600),
            MaxFrames = RayFrames,
            RateHz = 1,
            Masks = masks,
        };
        long rays = 0;
        LabelledTown.Harvest(game, ports, options, (frame, _) => rays += frame.Label.Rays!.Total);
        Assert.InRange(rays, 1, RayFrames * most);
    }

    private static SimulatedGame Warm()
    {
        var game = new SimulatedGame(new SimulationOptions { Seed = 3 });
        for (int tick = 0; tick < WarmingTicks; tick++)
        {
            game.Tick(1 / 60.0);
        }

        return game;
    }
}
