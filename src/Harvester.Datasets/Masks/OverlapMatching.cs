using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks;

/// <summary>
/// Finds out which object is meant by each number of another tool's map: the pair of number and object whose pixels agree best (the
/// intersection over union of the number's pixels and the cuboid's silhouette) is taken first, each number and each object once. An object
/// with parts agrees as well as the best of its own cuboid and theirs: little more than a sign's face may be seen of it.
/// </summary>
internal static class OverlapMatching
{
    /// <summary>
    /// An object hardly reaches out of its cuboid; a number with less than this share of its pixels within is another thing.
    /// </summary>
    private const double MinFractionWithin = 0.5;

    /// <summary>The objects' ids by the map's numbers; numbers that are no object's are missing.</summary>
    /// <param name="map">The map.</param>
    /// <param name="objects">The objects and their parts.</param>
    /// <param name="ownerOf">The id that the pixels of an object or a part have; 0 for none.</param>
    public static Dictionary<ushort, ushort> Match(InstanceMap map, IReadOnlyList<CuboidPixels> objects, Func<ushort, ushort> ownerOf)
    {
        Dictionary<ushort, int> areas = map.Ids.CountBy(number => number).ToDictionary();
        var pairs = new List<(double Agreement, ushort Id, ushort Number)>();
        foreach (CuboidPixels item in objects.Where(item => ownerOf(item.Id) != 0))
        {
            foreach ((ushort number, int shared) in item.Distances.Keys.CountBy(index => map.Ids[index]))
            {
                if (number != 0 && shared >= MinFractionWithin * areas[number])
                {
                    pairs.Add(((double)shared / (areas[number] + item.Distances.Count - shared), ownerOf(item.Id), number));
                }
            }
        }

        var ids = new Dictionary<ushort, ushort>();
        var taken = new HashSet<ushort>();
        foreach ((_, ushort id, ushort number) in pairs.OrderByDescending(p => p.Agreement).ThenBy(p => p.Id).ThenBy(p => p.Number))
        {
            if (!taken.Contains(id) && ids.TryAdd(number, id))
            {
                taken.Add(id);
            }
        }

        return ids;
    }
}
