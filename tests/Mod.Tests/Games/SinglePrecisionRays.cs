using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Mod.Tests.Games;

/// <summary>Rays as the game's API takes and answers them: both ends and the point of the hit in single precision.</summary>
internal sealed class SinglePrecisionRays(IRayCaster rays) : IRayCaster
{
    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        Vector3D start = SinglePrecisionWorld.Round(ray.Origin);
        Vector3D way = SinglePrecisionWorld.Round(ray.At(maxDistance)) - start;
        var rounded = new Ray(start, way);
        return rays.Cast(rounded, way.Length, ignoredEntity) is { } hit
            ? hit with
            {
                Distance = (SinglePrecisionWorld.Round(rounded.At(hit.Distance)) - ray.Origin).Length,
            }
            : null;
    }
}
