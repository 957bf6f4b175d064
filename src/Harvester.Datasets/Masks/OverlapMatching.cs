using Harvester.Geometry.PixelMaps;

namespace Harvester.Datasets.Masks;

/// <summary>
/// Matches the values of another tool's map with objects, greedily: the pair with the highest intersection over union of the value's pixels
/// and the cuboid's silhouette first, each value and each object once. For an object with parts, the best of its own cuboid and theirs
/// counts, because sometimes only a sign's face is visible.
/// </summary>
internal static class OverlapMatching
{
    /// <summary>Smallest fraction of a value's pixels inside the cuboid: objects hardly extend beyond their cuboids.</summary>
    private const double MinFractionWithin = 0.5;

    /// <summary>Object ids by map value; values without an object are absent.</summary>
    /// <param name="map">The map.</param>
    /// <param name="objects">The objects and their parts.</param>
    /// <param name="ownerOf">The id of an object's or part's pixels; 0 for none.</param>
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
