using System.Text.Json.Nodes;
using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests.Kitti;

[Collection(SimulatedSession.Collection)]
public sealed class KittiWriterTests(SimulatedSession simulated) : ExportTests
{
    /// <summary>A box of KITTI at the border ends in the middle of the last pixel.</summary>
    private const double BorderPixels = 0.51;

    /// <summary>Pixels are written with two decimals, metres with three.</summary>
    private const double RoundingPixels = 0.02;

    [Fact]
    public void Label_has_all_fifteen_columns_in_the_camera_frame()
    {
        Session.DeterminePedestrians();
        Folder.Export("kitti", Session.Open(), new ExportOptions { Boxes = BoxKind.Cuboid });

        // The car stands 11 m ahead and looks away from the camera, which looks north: centre (0, 0, 11) with y down, lower face 1 m below.
        // Looking along z is a turn of -90° from x. Boxes count from the centre of the first pixel: half a pixel less.
        Assert.Equal("Car 0 1 -1.5708 36.5 26.5 42.5 32.5 2 2 2 0 1 11 -1.5708", Folder.Lines("out/training/label_2/000000.txt")[0]);
        // The pedestrian, 6 m to the right and 5 m ahead, is cut at the last column: 79. alpha = -π/2 - atan(6 / 5) = -1.5708 - 0.8761.
        Assert.Equal("Pedestrian 0.2 0 -2.4469 69.5 23.5 79 35.5 2 2 0 6 1 5 -1.5708", Folder.Lines("out/training/label_2/000000.txt")[1]);
    }

    [Theory]
    // Turned left by 90°, the car looks to the camera's left, which is -x: a turn of 180°. Turned right it looks along x: 0.
    [InlineData(0, 1, -1, 0, 3.1416)]
    [InlineData(0, -1, 1, 0, 0)]
    [InlineData(-1, 0, 0, -1, 1.5708)]
    public void Rotation_y_is_the_angle_from_the_camera_right_axis(int rightX, int rightY, int forwardX, int forwardY, double expected)
    {
        Session.Car(0)["box3d"]!["right"] = new JsonArray(rightX, rightY, 0);
        Session.Car(0)["box3d"]!["forward"] = new JsonArray(forwardX, forwardY, 0);
        Folder.Export("kitti", Session.Open());

        Assert.Equal(expected, KittiObject.ReadAll(Folder.PathOf("out/training/label_2/000000.txt"))[0].RotationY);
    }

    [Fact]
    public void Calibration_is_that_of_the_label()
    {
        Folder.Export("kitti", Session.Open());

        string path = Folder.PathOf("out/training/calib/000002.txt");
        foreach (string name in (string[])["P0", "P1", "P2", "P3"])
        {
            Assert.Equal([30, 0, 39.5, 0, 0, 30, 29.5, 0, 0, 0, 1, 0], KittiObject.ReadMatrix(path, name));
        }

        Assert.Equal([1, 0, 0, 0, 1, 0, 0, 0, 1], KittiObject.ReadMatrix(path, "R0_rect"));
        Assert.Equal([0, -1, 0, 0, 0, 0, -1, 0, 1, 0, 0, 0], KittiObject.ReadMatrix(path, "Tr_velo_to_cam"));
        Assert.Equal([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], KittiObject.ReadMatrix(path, "Tr_imu_to_velo"));
    }

    [Fact]
    public void Boxes_projected_with_the_calibration_fall_onto_the_boxes()
    {
        Folder.Export("kitti", simulated.Open(), new ExportOptions { Boxes = BoxKind.Cuboid });
        int compared = 0;
        int ridden = 0;
        int frame = 0;
        foreach (FrameLabel label in simulated.Open().ReadLabels())
        {
            double[] p2 = KittiObject.ReadMatrix(Folder.PathOf($"out/training/calib/{frame:D6}.txt"), "P2");
            KittiObject[] written =
            [
                .. KittiObject.ReadAll(Folder.PathOf($"out/training/label_2/{frame:D6}.txt")).Where(item => item.Type != "DontCare"),
            ];
            ObjectLabel[] labels =
            [
                .. label.Objects.Where(item => item.Class is not (ObjectClass.Sign or ObjectClass.TrafficLight or ObjectClass.Rider)),
            ];
            Assert.Equal(labels.Length, written.Length);
            foreach ((KittiObject item, ObjectLabel source) in written.Zip(labels))
            {
                // The box of a two-wheeler with its rider is around both.
                if (label.Objects.FirstOrDefault(other => other.Vehicle == source.Id) is { } rider)
                {
                    Box2D both = source.Box2D.Union(rider.Box2D);
                    Assert.InRange(Math.Abs(item.Box.XMin + 0.5 - both.XMin), 0, BorderPixels);
                    Assert.InRange(Math.Abs(item.Box.YMin + 0.5 - both.YMin), 0, BorderPixels);
                    Assert.InRange(Math.Abs(item.Box.XMax + 0.5 - both.XMax), 0, BorderPixels);
                    Assert.InRange(Math.Abs(item.Box.YMax + 0.5 - both.YMax), 0, BorderPixels);
                    ridden++;
                    continue;
                }

                double allowed = AllowedPixels(source, label.Camera);
                if (item.Location.Z - source.Box3D.HalfExtents.Length < 1)
                {
                    continue;
                }

                Box2D projected = item.Project(p2);
                Box2D inImage = new(
                    Math.Max(projected.XMin, 0),
                    Math.Max(projected.YMin, 0),
                    Math.Min(projected.XMax, label.Camera.Width - 1),
                    Math.Min(projected.YMax, label.Camera.Height - 1)
                );
                Assert.InRange(Math.Abs(projected.XMin + 0.5 - source.Box2DAmodal.XMin), 0, allowed);
                Assert.InRange(Math.Abs(projected.YMin + 0.5 - source.Box2DAmodal.YMin), 0, allowed);
                Assert.InRange(Math.Abs(projected.XMax + 0.5 - source.Box2DAmodal.XMax), 0, allowed);
                Assert.InRange(Math.Abs(projected.YMax + 0.5 - source.Box2DAmodal.YMax), 0, allowed);
                if (source.TruncatedFraction == 0)
                {
                    Assert.InRange(Math.Abs(inImage.XMin - item.Box.XMin), 0, allowed);
                    Assert.InRange(Math.Abs(inImage.YMax - item.Box.YMax), 0, allowed);
                }

                compared++;
            }

            frame++;
        }

        Assert.True(compared > 2 * SimulatedSession.Frames);
        Assert.True(ridden > 0);
    }

    /// <summary>
    /// KITTI's boxes stand upright in the camera's frame. A box that leans by an angle t against it has its corners up to 2 sin(t / 2) of
    /// its half diagonal elsewhere, and its turn is measured on the tilted plane, which costs as much again at most; seen at depth z that
    /// is f / z times as many pixels, more towards the side.
    /// </summary>
    private static double AllowedPixels(ObjectLabel label, CameraLabel camera)
    {
        Vector3D centre = camera.Pose.ToLocal(label.Box3D.Centre);
        double lean = Math.Acos(Math.Min(1, label.Box3D.Axes.Up.Dot(camera.Pose.Axes.Up)));
        double displaced = 2 * 2 * Math.Sin(lean / 2) * label.Box3D.HalfExtents.Length;
        double nearest = Math.Max(0.1, centre.Y - label.Box3D.HalfExtents.Length);
        double sideways = 1 + (Math.Abs(centre.X) / nearest);
        return RoundingPixels + (0.001 * camera.Fx / nearest) + (camera.Fx * displaced * sideways / nearest);
    }
}
