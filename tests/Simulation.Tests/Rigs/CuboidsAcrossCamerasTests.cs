using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Rigs;
using Harvester.Simulation.Rendering;
using Xunit.Abstractions;

namespace Harvester.Simulation.Tests.Rigs;

/// <summary>
/// Cuboids in the label of one camera compared with what another camera shows: the pixels and depths that the renderer draws for it.
/// </summary>
public sealed class CuboidsAcrossCamerasTests(ITestOutputHelper output)
{
    /// <summary>The requirement.</summary>
    private const double Pixels = 1;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Cuboid_of_one_camera_holds_what_another_shows()
    {
        int compared = 0;
        int sensitive = 0;
        double worst = 0;
        foreach (int seed in new[] { 3, 61, 62, 63 })
        {
            var image = new ImageSize(800, 450);
            Rig rig = new("overlap", Vector3D.Zero,
            [
                RigHarvest.Camera("left", new Vector3D(-0.6, 1.7, 1.2), 20, image),
                RigHarvest.Camera("front", new Vector3D(0, 2, 1.4), 0, image),
                RigHarvest.Camera("right", new Vector3D(0.6, 1.7, 1.0), -20, image),
            ], []);
            var moment = new RigHarvest(rig, seed);
            moment.Game.Ports.Pause.Freeze();
            Dictionary<int, Cuboid>[] cuboids = [.. moment.Frames.Select(CuboidsByHandle)];
            for (int view = 0; view < rig.Cameras.Count; view++)
            {
                moment.Game.Ports.RigCamera!.Show(rig.Cameras[view], rig.OnVehicle(rig.Cameras[view].Mount));
                moment.Game.Tick(1.0 / 60);
                RenderTarget picture = moment.Game.Render(image);
                Camera camera = moment.Frames[view].Label.Camera.ToCamera();
                foreach (Dictionary<int, Cuboid> others in cuboids.Where((_, other) => other != view))
                {
                    foreach ((int handle, Cuboid cuboid) in others)
                    {
                        if (Farthest(picture, camera, handle, cuboid) is { } pixels)
                        {
                            worst = Math.Max(worst, pixels);
                            compared++;

                            // A cuboid half a metre beside the object would be noticed.
                            var moved = new Cuboid(cuboid.Centre + (camera.Pose.Axes.Right * 0.5), cuboid.HalfExtents, cuboid.Axes);
                            sensitive += Farthest(picture, camera, handle, moved) > Pixels ? 1 : 0;
                        }
                    }
                }
            }
        }

        output.WriteLine(FormattableString.Invariant($"{compared} cuboids, {sensitive} sensitive, at worst {worst:0.000} px"));
        Assert.InRange(compared, 20, int.MaxValue);
        Assert.InRange(sensitive, compared / 2, compared);
        Assert.InRange(worst, 0, Pixels);
    }

    private static Dictionary<int, Cuboid> CuboidsByHandle(CapturedFrame frame) => frame.Scene!.Ids
        .Join(
            frame.Label.Objects.Where(item => item.Parent is null), pair => pair.Value, item => item.Id,
            (pair, item) => (pair.Key, item.Box3D))
        .ToDictionary(pair => pair.Key, pair => pair.Box3D);

    /// <summary>How far outside a cuboid the points of an object are that a picture shows, pixels; null if it shows none.</summary>
    private static double? Farthest(RenderTarget picture, Camera camera, int handle, Cuboid cuboid)
    {
        double? farthest = null;
        for (int at = 0; at < picture.Handles.Length; at++)
        {
            if (picture.Handles[at] == handle)
            {
                double depth = picture.Depth[at];
                Vector3D point = camera.Unproject((at % picture.Width) + 0.5, (at / picture.Width) + 0.5, depth);
                Vector3D inside = cuboid.Axes.ToLocal(point - cuboid.Centre);
                var outside = new Vector3D(
                    Math.Max(0, Math.Abs(inside.X) - cuboid.HalfExtents.X),
                    Math.Max(0, Math.Abs(inside.Y) - cuboid.HalfExtents.Y),
                    Math.Max(0, Math.Abs(inside.Z) - cuboid.HalfExtents.Z));
                farthest = Math.Max(farthest ?? 0, outside.Length * camera.Intrinsics.Fx / depth);
            }
        }

        return farthest;
    }
}
