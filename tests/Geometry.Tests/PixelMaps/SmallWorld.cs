using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Geometry.Tests.PixelMaps;

/// <summary>A camera at the origin that looks north, and things to put before it.</summary>
internal static class SmallWorld
{
    public static Camera Camera { get; } = Sized(new ImageSize(800, 600));

    public static Camera Sized(ImageSize size) =>
        new(new Pose(Vector3D.Zero, Axes.Identity), new CameraIntrinsics(50, size, 4.0 / 3, 0.1, Lens.Ideal));

    public static MapTarget Target(int entity, ushort number, Cuboid cuboid) =>
        new(entity, number, cuboid, CuboidProjector.Project(Camera, cuboid));
}
