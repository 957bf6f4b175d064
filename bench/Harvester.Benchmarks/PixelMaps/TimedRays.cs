using System.Diagnostics;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;

namespace Harvester.Benchmarks.PixelMaps;

/// <summary>Passes rays on and measures how long they take, so that a mapper's own time can be separated from the scene's.</summary>
internal sealed class TimedRays(IRayCaster rays) : IRayCaster
{
    private long _ticks;

    public TimeSpan Elapsed => Stopwatch.GetElapsedTime(0, _ticks);

    public RayHit? Cast(Ray ray, double maxDistance, int ignoredEntity)
    {
        long before = Stopwatch.GetTimestamp();
        RayHit? hit = rays.Cast(ray, maxDistance, ignoredEntity);
        _ticks += Stopwatch.GetTimestamp() - before;
        return hit;
    }
}
