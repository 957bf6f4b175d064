using FsCheck;
using FsCheck.Fluent;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.TestSupport;

namespace Harvester.Geometry.Tests;

/// <summary>Random geometry for properties, which shrinks towards the origin and towards axes along the world's.</summary>
internal static class Draws
{
    /// <summary>Points of a cube about the origin.</summary>
    public static Arbitrary<Vector3D> Vectors(double half) => Vectors(-half, half);

    /// <summary>Points whose coordinates all lie in one range.</summary>
    public static Arbitrary<Vector3D> Vectors(double min, double max) =>
        Arb.Convert(
            RandomCases.ArrayOf(RandomCases.Number(min, max), 3),
            numbers => new Vector3D(numbers[0], numbers[1], numbers[2]),
            vector => new[] { vector.X, vector.Y, vector.Z }
        );

    /// <summary>Points of the plane, each coordinate from 0 to a limit.</summary>
    public static Arbitrary<Vector2D> Pixels(double width, double height) =>
        Arb.Convert(
            Arb.Zip(RandomCases.Number(0, width), RandomCases.Number(0, height)),
            pixel => new Vector2D(pixel.Item1, pixel.Item2),
            pixel => (pixel.X, pixel.Y)
        );

    /// <summary>Orientations of any heading and roll.</summary>
    public static Arbitrary<EulerAngles> Orientations(double maxPitch = 90) =>
        Arb.Convert(
            Arb.Zip(RandomCases.Number(-maxPitch, maxPitch), Arb.Zip(RandomCases.Number(-180, 180), RandomCases.Number(-180, 180))),
            angles => new EulerAngles(angles.Item1, angles.Item2.Item1, angles.Item2.Item2),
            angles => (angles.PitchDegrees, (angles.RollDegrees, angles.YawDegrees))
        );

    /// <summary>Poses within a cube about the origin.</summary>
    public static Arbitrary<Pose> Poses(double half) =>
        Arb.Convert(
            Arb.Zip(Vectors(half), Orientations()),
            pose => new Pose(pose.Item1, Axes.FromEuler(pose.Item2)),
            pose => (pose.Position, pose.Axes.ToEuler())
        );

    /// <summary>Cuboids of 0.2 to 6 m a side.</summary>
    public static Arbitrary<Cuboid> Cuboids(Arbitrary<Vector3D> centre) =>
        Arb.Convert(
            Arb.Zip(centre, Arb.Zip(Vectors(0.1, 3), Orientations())),
            drawn => new Cuboid(drawn.Item1, drawn.Item2.Item1, Axes.FromEuler(drawn.Item2.Item2)),
            cuboid => (cuboid.Centre, (cuboid.HalfExtents, cuboid.Axes.ToEuler()))
        );

    /// <summary>Cameras anywhere, with images of 800x600.</summary>
    public static Arbitrary<Camera> Cameras(Lens lens) =>
        Arb.Convert(
            Arb.Zip(Poses(100), Arb.Zip(RandomCases.Number(20, 100), RandomCases.Number(1, 2))),
            drawn => new Camera(
                drawn.Item1,
                new CameraIntrinsics(drawn.Item2.Item1, new ImageSize(800, 600), drawn.Item2.Item2, 0.1, lens)
            ),
            camera => (camera.Pose, (camera.Intrinsics.VerticalFovDegrees, camera.Intrinsics.WindowAspect))
        );
}
