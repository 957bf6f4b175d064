using System.Collections.Generic;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Visibility;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Finds out which objects rays do not meet at all, as against those that are hidden: of a map that shows nothing of an object,
/// although rays went all the way through its cuboid, probes that start at the cuboid decide.
/// </summary>
internal sealed class UnmetTargets
{
    /// <summary>So many rays through the cuboid make an object suspicious; thin objects fill little of their cuboids.</summary>
    private const int SuspiciousRays = 4;

    /// <summary>So many probes must meet nothing of it.</summary>
    private const int Probes = 64;

    private readonly Queue<(TargetView View, EntityProbe Probe, Queue<Ray> Rays)> _suspects = new();

    public UnmetTargets(
        Camera camera, IReadOnlyList<TargetView> views, PixelSamples samples, InstanceMap map, int ignoredEntity, IRayCaster rays)
    {
        var shown = new HashSet<ushort>(map.Ids);
        foreach (TargetView view in views)
        {
            if (!shown.Contains(view.Target.Number) && IsSuspicious(camera, view, samples))
            {
                var probe = new EntityProbe(camera, view, ignoredEntity, rays);
                _suspects.Enqueue((view, probe, new Queue<Ray>(probe.Through(Probes))));
            }
        }
    }

    /// <summary>The objects that no probe has met.</summary>
    public List<MapTarget> Unmet { get; } = [];

    public int RaysCast { get; private set; }

    /// <summary>Casts one probe.</summary>
    /// <returns>False when none is left.</returns>
    public bool Step()
    {
        while (_suspects.Count > 0)
        {
            (TargetView view, EntityProbe probe, Queue<Ray> towards) = _suspects.Peek();
            if (towards.Count == 0)
            {
                Unmet.Add(view.Target);
                _suspects.Dequeue();
                continue;
            }

            RaysCast++;
            if (probe.Meets(towards.Dequeue()))
            {
                _suspects.Dequeue();
            }

            return true;
        }

        return false;
    }

    private static bool IsSuspicious(Camera camera, TargetView view, PixelSamples samples)
    {
        int through = 0;
        for (int row = view.Spans.FirstRow; row <= view.Spans.LastRow; row++)
        {
            (int first, int last) = view.Spans.Row(row);
            for (int column = first; column <= last; column++)
            {
                if (samples.IsCast(column, row)
                    && view.Target.Cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is { } span
                    && samples.Distance(column, row) > span.Exit
                    && ++through >= SuspiciousRays)
                {
                    return true;
                }
            }
        }

        return false;
    }
}
