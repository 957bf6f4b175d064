using System;
using System.Collections.Generic;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.PixelMaps;
using Harvester.Geometry.Visibility;

namespace Harvester.Capture.Labelling;

/// <summary>A ray for every pixel of the box around all objects, a row a slice.</summary>
internal sealed class ExhaustiveInstanceMapper : IInstanceMapper
{
    public IEnumerable<bool> Fill(
        Camera camera, IReadOnlyList<Box2D> boxes, Func<int, ushort> numberOf, int ignoredEntity, IRayCaster rays, InstanceMap map)
    {
        if (boxes.Count == 0)
        {
            yield break;
        }

        Box2D region = boxes[0];
        foreach (Box2D box in boxes)
        {
            region = region.Union(box);
        }

        for (double top = Math.Floor(region.YMin); top < region.YMax; top++)
        {
            var row = new Box2D(region.XMin, Math.Max(top, region.YMin), region.XMax, Math.Min(top + 1, region.YMax));
            ExhaustivePixelMapper.MapInto(map, camera, row, numberOf, ignoredEntity, rays);
            yield return true;
        }
    }
}
