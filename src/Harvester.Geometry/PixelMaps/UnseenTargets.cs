using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Classifies the objects without a pixel in a map: those that are hidden or outside the image, and those that rays do not hit. If all rays
/// through the silhouette were stopped in front of the cuboid, the object is hidden; otherwise rays that start at the cuboid decide.
/// </summary>
internal sealed class UnseenTargets
{
    private readonly Queue<(ushort Number, CuboidProbe Probe, Queue<Ray> Rays)> _open = new();
    private readonly Dictionary<ushort, Sight> _sights = [];

    public UnseenTargets(
        Camera camera,
        IReadOnlyList<TargetView> views,
        PixelSamples samples,
        int[] shown,
        int ignoredEntity,
        IRayCaster rays
    )
    {
        foreach (TargetView view in views)
        {
            ushort number = view.Target.Number;
            if (shown[number] > 0)
            {
                continue;
            }

            if (samples.HasMet(number) || AreAllStopped(camera, view, samples))
            {
                _sights[number] = Sight.Unseen;
                continue;
            }

            var probe = new CuboidProbe(camera.Pose.Position, view.Target.Cuboid, view.Target.Entity, ignoredEntity, rays);
            _open.Enqueue((number, probe, new Queue<Ray>(probe.Through(SightFinder.Probes))));
        }
    }

    public int RaysCast { get; private set; }

    /// <summary>What is known of an object without a pixel in the map; not asked while rays for it are left to cast.</summary>
    public Sight SightOf(ushort number) => _sights.TryGetValue(number, out Sight sight) ? sight : Sight.NotAsked;

    /// <summary>Casts one ray.</summary>
    /// <returns>False if no ray is left to cast.</returns>
    public bool Step()
    {
        while (_open.Count > 0)
        {
            (ushort number, CuboidProbe probe, Queue<Ray> towards) = _open.Peek();
            if (towards.Count == 0)
            {
                _sights[number] = Sight.Undetermined;
                _open.Dequeue();
                continue;
            }

            RaysCast++;
            if (probe.Meets(towards.Dequeue()))
            {
                _sights[number] = Sight.Unseen;
                _open.Dequeue();
            }

            return true;
        }

        return false;
    }

    private static bool AreAllStopped(Camera camera, TargetView view, PixelSamples samples)
    {
        bool isAsked = false;
        for (int row = view.Spans.FirstRow; row <= view.Spans.LastRow; row++)
        {
            (int first, int last) = view.Spans.Row(row);
            for (int column = first; column <= last; column++)
            {
                if (samples.IsCast(column, row) && view.Target.Cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is { } span)
                {
                    isAsked = true;
                    if (samples.Distance(column, row) >= span.Entry)
                    {
                        return false;
                    }
                }
            }
        }

        return isAsked;
    }
}
