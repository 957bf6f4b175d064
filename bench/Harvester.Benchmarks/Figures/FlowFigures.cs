using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Motion;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;

namespace Harvester.Benchmarks.Figures;

/// <summary>What the flow between two pictures of 800 x 600 costs, in both directions, besides the surfaces and the files.</summary>
internal static class FlowFigures
{
    private const int TicksBetween = 6;

    private static readonly ImageSize Size = new(800, 600);

    public static void Run(SimulatedGame game)
    {
        (SurfaceMap before, Dictionary<int, Pose> posesBefore) = Read(game);
        for (int tick = 0; tick < TicksBetween; tick++)
        {
            game.Tick(1 / 60.0);
        }

        (SurfaceMap now, Dictionary<int, Pose> poses) = Read(game);
        double seconds = Stopclock.BestSeconds(() =>
        {
            new FlowMaker(now, before, handle => Motion(poses, posesBefore, handle), hasMotion: true).Make();
            new FlowMaker(before, now, handle => Motion(posesBefore, poses, handle), hasMotion: false).Make();
        });
        FigureLine.Write("flow.milliseconds", 1000 * seconds);
    }

    private static (SurfaceMap, Dictionary<int, Pose>) Read(SimulatedGame game)
    {
        SceneSnapshot shown = game.Shown;
        CameraState camera = shown.Camera;
        var lines = new PixelLines(new CameraIntrinsics(camera.VerticalFovDegrees, Size, camera.WindowAspect, camera.NearClip, Lens.Ideal));
        (float[] metres, int[] entities) = game.Ports.Surfaces!.Surfaces(Size);
        return (
            new SurfaceMap(camera.Pose, lines, metres, entities),
            shown.Entities.ToDictionary(static entity => entity.Handle, static entity => entity.Pose)
        );
    }

    private static BodyMotion Motion(Dictionary<int, Pose> from, Dictionary<int, Pose> to, int handle) =>
        from.TryGetValue(handle, out Pose start) && to.TryGetValue(handle, out Pose end)
            ? BodyMotion.Rigid(start, end)
            : new BodyMotion(BodyMotionKind.Unknown);
}
