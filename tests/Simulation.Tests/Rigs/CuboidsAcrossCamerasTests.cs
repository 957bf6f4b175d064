using Harvester.Capture.Harvesting;
using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Labels;
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

    /// <summary>The default options: a labelled object has a box of at least 16 square pixels with sides of at least 2.</summary>
    private const int MinPixels = 16;
    private const int MinSide = 2;

    /// <summary>
    /// An object is labelled if a ray has met it. If a tenth of its box shows it, some of the rays through the box meet it.
    /// </summary>
    private const double MinShareShown = 0.1;

    /// <summary>Fewer cases would prove little.</summary>
    private const int MinCompared = 20;

    [Fact]
    [Trait("Category", "Heavy")]
    public void Cuboid_of_one_camera_holds_what_another_shows()
    {
        int compared = 0;
        int sensitive = 0;
        double worst = 0;
        foreach ((CapturedFrame frame, RenderTarget picture, CapturedFrame[] others) in Views())
        {
            Camera camera = frame.Label.Camera.ToCamera();
            foreach ((int handle, Cuboid cuboid) in others.SelectMany(CuboidsByHandle))
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

        output.WriteLine(FormattableString.Invariant($"{compared} cuboids, {sensitive} sensitive, at worst {worst:0.000} px"));
        Assert.InRange(compared, MinCompared, int.MaxValue);
        Assert.InRange(sensitive, compared / 2, compared);
        Assert.InRange(worst, 0, Pixels);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Object_that_two_cameras_show_is_labelled_in_both()
    {
        int required = 0;
        int open = 0;
        int absent = 0;
        foreach ((CapturedFrame frame, RenderTarget picture, CapturedFrame[] others) in Views())
        {
            CameraLabel camera = frame.Label.Camera;
            Dictionary<int, Cuboid> labelled = CuboidsByHandle(frame);
            foreach ((int handle, Cuboid cuboid) in others.SelectMany(CuboidsByHandle))
            {
                (int shown, int width, int height) = ShownOf(picture, handle);
                string which = FormattableString.Invariant($"{handle} in {frame.Label.View}: {shown} pixels, {width} x {height}");
                if (shown == 0)
                {
                    absent++;
                    Assert.False(labelled.ContainsKey(handle), which);
                }
                else if (shown >= MinPixels && Math.Min(width, height) >= MinSide && shown >= MinShareShown * BoxArea(camera, cuboid))
                {
                    required++;
                    Assert.True(labelled.ContainsKey(handle), which);
                }
                else
                {
                    open++;
                }
            }
        }

        output.WriteLine(FormattableString.Invariant($"{required} must be labelled, {absent} must not, {open} may be"));
        Assert.InRange(required, MinCompared, int.MaxValue);
        Assert.InRange(absent, MinCompared, int.MaxValue);
        Assert.InRange(open, 0, required);
    }

    /// <summary>Views of cameras that see partly the same: the frame, what the renderer draws, the other frames of the moment.</summary>
    private static IEnumerable<(CapturedFrame Frame, RenderTarget Picture, CapturedFrame[] Others)> Views()
    {
        foreach (int seed in new[] { 3, 61, 62, 63 })
        {
            var image = new ImageSize(800, 450);
            Rig rig = new(
                "overlap",
                Vector3D.Zero,
                [
                    RigHarvest.Camera("left", new Vector3D(-0.6, 1.7, 1.2), 20, image),
                    RigHarvest.Camera("front", new Vector3D(0, 2, 1.4), 0, image),
                    RigHarvest.Camera("right", new Vector3D(0.6, 1.7, 1.0), -20, image),
                ],
                []
            );
            var moment = new RigHarvest(rig, seed);
            moment.Game.Ports.Pause.Freeze();
            foreach ((RigCamera camera, CapturedFrame frame) in rig.Cameras.Zip(moment.Frames))
            {
                moment.Game.Ports.RigCamera!.Show(camera, rig.OnVehicle(camera.Mount));
                moment.Game.Tick(1.0 / 60);
                yield return (frame, moment.Game.Render(image), [.. moment.Frames.Where(other => other != frame)]);
            }
        }
    }

    /// <summary>Number of the pixels that show an object, and the sides of the box around them.</summary>
    private static (int Pixels, int Width, int Height) ShownOf(RenderTarget picture, int handle)
    {
        int[] at = [.. Enumerable.Range(0, picture.Handles.Length).Where(pixel => picture.Handles[pixel] == handle)];
        return at.Length == 0
            ? (0, 0, 0)
            : (
                at.Length,
                at.Max(pixel => pixel % picture.Width) - at.Min(pixel => pixel % picture.Width) + 1,
                (at[^1] / picture.Width) - (at[0] / picture.Width) + 1
            );
    }

    /// <summary>Area of the box around a cuboid, cut at the image; infinite for a cuboid that is partly behind the camera.</summary>
    private static double BoxArea(CameraLabel camera, Cuboid cuboid)
    {
        double left = double.PositiveInfinity,
            top = left,
            right = -left,
            bottom = -left;
        for (int corner = 0; corner < Cuboid.CornerCount; corner++)
        {
            Vector3D there = cuboid.Corner(corner) - camera.Pose.Position;
            double depth = there.Dot(camera.Pose.Axes.Forward);
            if (depth < 0.1)
            {
                return double.PositiveInfinity;
            }

            double x = camera.Cx + (camera.Fx * there.Dot(camera.Pose.Axes.Right) / depth);
            double y = camera.Cy - (camera.Fy * there.Dot(camera.Pose.Axes.Up) / depth);
            (left, right, top, bottom) = (Math.Min(left, x), Math.Max(right, x), Math.Min(top, y), Math.Max(bottom, y));
        }

        return (Math.Min(right, camera.Width) - Math.Max(left, 0)) * (Math.Min(bottom, camera.Height) - Math.Max(top, 0));
    }

    private static Dictionary<int, Cuboid> CuboidsByHandle(CapturedFrame frame) =>
        frame
            .Scene!.Ids.Join(
                frame.Label.Objects.Where(item => item.Parent is null),
                pair => pair.Value,
                item => item.Id,
                (pair, item) => (pair.Key, item.Box3D)
            )
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
                    Math.Max(0, Math.Abs(inside.Z) - cuboid.HalfExtents.Z)
                );
                farthest = Math.Max(farthest ?? 0, outside.Length * camera.Intrinsics.Fx / depth);
            }
        }

        return farthest;
    }
}
