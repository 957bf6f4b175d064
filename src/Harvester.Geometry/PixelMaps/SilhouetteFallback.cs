using System;
using System.Collections.Generic;
using Harvester.Geometry.Boxes;
using Harvester.Geometry.Cameras;

namespace Harvester.Geometry.PixelMaps;

/// <summary>
/// Draws objects that rays do not meet by their cuboids' silhouettes. Nearer objects, and pixels where a ray met something nearer,
/// stay as they are.
/// </summary>
internal sealed class SilhouetteFallback(Camera camera, PixelSamples samples)
{
    /// <summary>
    /// What is no target has no outline of its own: the nearest asked pixel of such on the row or column, within this many pixels, speaks for
    /// the pixels around it.
    /// </summary>
    private const int Reach = 16;

    /// <summary>Adds objects to a map that was made without them.</summary>
    public void Draw(InstanceMap map, IReadOnlyList<MapTarget> unmet, IReadOnlyList<MapTarget> all)
    {
        var distances = new Dictionary<ushort, double>();
        foreach (MapTarget target in all)
        {
            distances[target.Number] = SilhouettePainter.DistanceOf(camera, target);
        }

        // Nearest first: what is drawn hides what comes after it.
        var nearestFirst = new List<MapTarget>(unmet);
        nearestFirst.Sort((a, b) => distances[a.Number].CompareTo(distances[b.Number]));
        foreach (MapTarget target in nearestFirst)
        {
            if (target.Projection.Box is { } box)
            {
                Draw(map, target, new SilhouetteSpans(target.Projection.Silhouette, box, camera.Image), distances);
            }
        }
    }

    private void Draw(InstanceMap map, MapTarget target, SilhouetteSpans spans, Dictionary<ushort, double> distances)
    {
        for (int row = spans.FirstRow; row <= spans.LastRow; row++)
        {
            (int first, int last) = spans.Row(row);
            for (int column = first; column <= last; column++)
            {
                ushort there = map[column, row];
                bool isHidden = there != 0 ? distances[there] <= distances[target.Number] : MetNearer(target.Cuboid, column, row);
                if (!isHidden)
                {
                    map[column, row] = target.Number;
                }
            }
        }
    }

    private bool MetNearer(Cuboid cuboid, int column, int row)
    {
        if (cuboid.Intersect(camera.RayThrough(column + 0.5, row + 0.5)) is not { } span)
        {
            return false;
        }

        for (int away = 0; away <= Reach; away++)
        {
            foreach ((int c, int r) in new[] { (column - away, row), (column + away, row), (column, row - away), (column, row + away) })
            {
                if (camera.Image.Contains(c, r) && samples.HasDistance(c, r) && samples.Number(c, r) == 0)
                {
                    return samples.Distance(c, r) < Math.Max(span.Entry, camera.Intrinsics.NearClip);
                }
            }
        }

        return false;
    }
}
