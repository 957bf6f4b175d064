using Harvester.Geometry;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Capture.Tests.Labelling;

/// <summary>Camera, cuboids, boxes and class rules against the depth and the kinds of the pixels of one frame of the real game.</summary>
public sealed class RealFrameTests
{
    /// <summary>
    /// The range of the test, metres of depth. One step of the 16-bit depth is z² / 9830: 4 cm at 20 m and 37 cm here.
    /// </summary>
    private const double Near = 60;

    /// <summary>Vehicle pixels nearer than that, counted in the files of the frame.</summary>
    private const int NearPixels = 17_014;

    /// <summary>
    /// How many of them lie outside: 4 of one vehicle at 47.7 m, by 15 to 19 mm, where half a step of the depth is 116 mm. That is the
    /// 99.98 % inside that were measured by other mathematics.
    /// </summary>
    private const int PixelsOutside = 4;

    /// <summary>Margin about the cuboids within which the other measurement found all pixels, metres.</summary>
    private const double Margin = 0.05;

    /// <summary>Greatest fraction inside with a wrong camera: half a degree of yaw leaves 0.902, a degree of field of view 0.956.</summary>
    private const double WrongCameraFraction = 0.97;

    /// <summary>The fractions of the other measurement have two digits, cut or rounded.</summary>
    private const double Rounding = 0.01;

    [RealWorldFact(RealFrame.Scene)]
    public void Vehicle_pixels_lie_in_the_cuboids_of_vehicles()
    {
        RealFrame frame = RealFrame.Read();
        Vector3D[] points = Points(frame, frame.Camera);

        Assert.Equal(NearPixels, points.Length);
        Assert.InRange(Outside(frame, points, margin: 0), 0, PixelsOutside);
        Assert.Equal(0, Outside(frame, points, Margin));
    }

    [RealWorldFact(RealFrame.Scene)]
    public void Vehicle_pixels_leave_the_cuboids_if_the_camera_is_wrong()
    {
        RealFrame frame = RealFrame.Read();
        Camera camera = frame.Camera;
        EulerAngles angles = camera.Pose.Axes.ToEuler();
        var turned = new Camera(
            camera.Pose with
            {
                Axes = Axes.FromEuler(angles with { YawDegrees = angles.YawDegrees + 0.5 }),
            },
            camera.Intrinsics
        );
        var wide = new Camera(
            camera.Pose,
            new CameraIntrinsics(51, camera.Image, camera.Intrinsics.WindowAspect, camera.Intrinsics.NearClip, Lens.Ideal)
        );

        Assert.InRange(FractionInside(frame, turned), 0, WrongCameraFraction);
        Assert.InRange(FractionInside(frame, wide), 0, WrongCameraFraction);
    }

    [RealWorldFact(RealFrame.Scene)]
    public void Box_of_a_near_car_holds_its_pixels_loosely()
    {
        RealFrame frame = RealFrame.Read();
        (string _, Cuboid car) = frame
            .Vehicles.Where(vehicle => vehicle.GameClass == "Muscle")
            .Where(vehicle => frame.Camera.Project(vehicle.Cuboid.Centre).Outcome == ProjectionOutcome.InImage)
            .MinBy(vehicle => (vehicle.Cuboid.Centre - frame.Camera.Pose.Position).Length);
        (int X, int Y, double Depth)[] pixels =
        [
            .. frame.VehiclePixels(Near).Where(pixel => car.Contains(frame.Camera.Unproject(pixel.X + 0.5, pixel.Y + 0.5, pixel.Depth))),
        ];
        Box2D drawn = new(
            pixels.Min(pixel => pixel.X),
            pixels.Min(pixel => pixel.Y),
            pixels.Max(pixel => pixel.X) + 1,
            pixels.Max(pixel => pixel.Y) + 1
        );
        Box2D box = CuboidProjector.BoxesOf(frame.Camera, car).Box!.Value;

        // A pixel belongs to the box if its centre does; its edges may be half a pixel outside.
        Assert.True(box.Contains(drawn, margin: 0.5), $"{drawn} is not in {box}.");
        Assert.Equal(0.78, box.IntersectionOverUnion(drawn), Rounding);
        Assert.Equal(0.49, pixels.Length / box.Area, Rounding);
    }

    [RealWorldFact(RealFrame.Scene)]
    public void Vehicles_have_the_classes_that_the_game_names()
    {
        string[] lorries = ["Industrial", "Commercial"];

        Assert.All(
            RealFrame.Read().Vehicles,
            vehicle =>
                Assert.Equal(
                    lorries.Contains(vehicle.GameClass) ? ObjectClass.Truck : ObjectClass.Car,
                    VehicleClasses.Of(model: 0, NumberOf(vehicle.GameClass))
                )
        );
    }

    private static Vector3D[] Points(RealFrame frame, Camera camera) =>
        [.. frame.VehiclePixels(Near).Select(pixel => camera.Unproject(pixel.X + 0.5, pixel.Y + 0.5, pixel.Depth))];

    private static double FractionInside(RealFrame frame, Camera camera) =>
        1 - ((double)Outside(frame, Points(frame, camera), margin: 0) / NearPixels);

    private static int Outside(RealFrame frame, Vector3D[] points, double margin)
    {
        Cuboid[] cuboids =
        [
            .. frame.Vehicles.Select(vehicle => new Cuboid(
                vehicle.Cuboid.Centre,
                vehicle.Cuboid.HalfExtents + new Vector3D(margin, margin, margin),
                vehicle.Cuboid.Axes
            )),
        ];
        return points.Count(point => !cuboids.Any(cuboid => cuboid.Contains(point)));
    }

    /// <summary>The game's number of a vehicle class, from the list of GET_VEHICLE_CLASS.</summary>
    private static int NumberOf(string name) =>
        name switch
        {
            "Compacts" => 0,
            "Sedans" => 1,
            "SUVs" => 2,
            "Muscle" => 4,
            "Industrial" => 10,
            "Utility" => 11,
            "Vans" => 12,
            "Commercial" => 20,
            _ => throw new InvalidDataException($"The frame has vehicles of the class {name}."),
        };
}
