using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Tests.Scenes;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.Tests.PixelMaps;

/// <summary>Makes adaptive maps of scenes.</summary>
internal static class MapRun
{
    public static AdaptivePixelMapper Of(TownScene scene, IReadOnlyList<MapTarget> targets, PixelMapOptions options) =>
        new(scene.Camera, targets, RayHit.World, scene, options);

    public static AdaptivePixelMap Complete(TownScene scene, IReadOnlyList<MapTarget> targets) => Complete(scene.Camera, scene, targets);

    public static AdaptivePixelMap Complete(Camera camera, IRayCaster rays, IReadOnlyList<MapTarget> targets)
    {
        var mapper = new AdaptivePixelMapper(camera, targets, RayHit.World, rays, new PixelMapOptions());
        mapper.Run();
        return mapper.Finish();
    }
}
