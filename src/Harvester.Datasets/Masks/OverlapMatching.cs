using System.Collections.Generic;
using System.Linq;
using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks;

/// <summary>
/// Finds out which object is meant by each number of another tool's map: the pair of number and object whose pixels agree best (the
/// intersection over union of the number's pixels and the cuboid's silhouette) is taken first, each number and each object once.
/// </summary>
internal static class OverlapMatching
{
    /// <summary>An object hardly reaches out of its cuboid; a number with less than this share of its pixels within is another thing.</summary>
    private const double LeastFractionWithin = 0.5;

    /// <summary>The objects' ids by the map's numbers; numbers that are no object's are missing.</summary>
    public static Dictionary<ushort, ushort> Match(InstanceMap map, IReadOnlyList<CuboidPixels> objects)
    {
        Dictionary<ushort, int> areas = map.Ids.CountBy(number => number).ToDictionary();
        var pairs = new List<(double Agreement, ushort Id, ushort Number)>();
        foreach (CuboidPixels item in objects)
        {
            foreach ((ushort number, int shared) in item.Distances.Keys.CountBy(index => map.Ids[index]))
            {
                if (number != 0 && shared >= LeastFractionWithin * areas[number])
                {
                    pairs.Add(((double)shared / (areas[number] + item.Distances.Count - shared), item.Id, number));
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
