using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.Tests;

/// <summary>Seeded draws of things that tests need many of.</summary>
internal static class Sampling
{
    public static double Between(this Random random, double low, double high) => low + ((high - low) * random.NextDouble());

    public static Vector3D Vector(this Random random, double half) =>
        new(random.Between(-half, half), random.Between(-half, half), random.Between(-half, half));

    public static Axes Axes(this Random random) =>
        Harvester.Geometry.Axes.FromEuler(new EulerAngles(random.Between(-90, 90), random.Between(-180, 180), random.Between(-180, 180)));

    public static Camera Camera(this Random random, Lens lens) =>
        new(
            new Pose(random.Vector(100), random.Axes()),
            new CameraIntrinsics(random.Between(20, 100), new ImageSize(800, 600), random.Between(1, 2), 0.1, lens)
        );
}
