using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Grids;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Semantics;
using Harvester.Simulation.Game;

namespace Harvester.Benchmarks.Figures;

/// <summary>What the voxels around a vehicle cost: the box that is filled once a moment, and what each camera sees of it.</summary>
internal static class VoxelFigures
{
    private static readonly ImageSize Size = new(800, 600);

    public static void Run(SimulatedGame game)
    {
        SceneSnapshot shown = game.Shown;
        byte[] ranks = [.. Enumerable.Range(0, SemanticClasses.Greatest + 1).Select(static kind => (byte)kind)];
        Dictionary<int, SemanticClass> classes = shown.Entities.ToDictionary(
            static entity => entity.Handle,
            static entity => SemanticClasses.Of(entity.Class)
        );
        double height = -(shown.Ego.HeightAboveGroundMetres ?? 0);
        int runs = 0;
        VoxelMap map = Fill();
        FigureLine.Write("occupancy.milliseconds", 1000 * Stopclock.BestSeconds(() => map = Fill()));

        CameraState state = shown.Camera;
        var camera = new Camera(
            state.Pose,
            new CameraIntrinsics(state.VerticalFovDegrees, Size, state.WindowAspect, state.NearClip, Lens.Ideal)
        );
        float[] depths = game.Ports.Surfaces!.Surfaces(Size).Metres;
        FigureLine.Write("occupancy.sight.milliseconds", 1000 * Stopclock.BestSeconds(() => VoxelSight.Of(camera, map, depths)));

        // The port keeps the map of the last box, so each one is moved by a micrometre.
        VoxelMap Fill() =>
            game.Ports.Solids!.Fill(
                new VoxelGrid(
                    new Pose(shown.Ego.Pose.ToWorld(new Vector3D(0, 0, height + (1e-6 * ++runs))), shown.Ego.Pose.Axes),
                    VoxelShape.Usual
                ),
                ranks,
                handle => classes.GetValueOrDefault(handle, SemanticClass.Other)
            );
    }
}
