using Harvester.Geometry.Grids;
using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Semantics;

namespace Harvester.Datasets.Validation;

/// <summary>
/// Checks the voxels of a frame: each has a class, is free or enclosed; only voxels of objects have a number; each is seen or not, and
/// those that are enclosed are not.
/// </summary>
internal static class OccupancyCheck
{
    /// <summary>What is wrong with the maps, one line each.</summary>
    /// <param name="label">What the label says of them.</param>
    /// <param name="readLabels">Reads a map of 8 bits of the session.</param>
    /// <param name="readIds">Reads a map of 16 bits.</param>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">A map cannot be read.</exception>
    public static IEnumerable<string> Problems(
        OccupancyLabel label,
        Func<string, InstanceMap> readLabels,
        Func<string, InstanceMap> readIds
    )
    {
        ushort[] classes = readLabels(label.File).Ids;
        ushort[] ids = readIds(label.Instances).Ids;
        ushort[] seen = readLabels(label.Visible).Ids;
        if (Array.FindIndex(classes, static value => value is > SemanticClasses.Greatest and not VoxelMap.Enclosed) is >= 0 and var stray)
        {
            yield return $"map of voxels '{label.File}' has the value {classes[stray]}, which is no class. Values are 0 to "
                + $"{SemanticClasses.Greatest} and {VoxelMap.Enclosed}.";
        }
        else if (Enumerable.Range(0, ids.Length).Any(voxel => ids[voxel] != 0 && !IsObject(classes[voxel])))
        {
            yield return $"map of voxels '{label.Instances}' has a number where '{label.File}' has no object.";
        }

        if (Array.FindIndex(seen, static value => value is not (0 or OccupancyLabel.Seen)) is >= 0 and var other)
        {
            yield return $"map of voxels '{label.Visible}' has the value {seen[other]}. Its voxels are 0 or {OccupancyLabel.Seen}.";
        }
        else if (Enumerable.Range(0, seen.Length).Any(voxel => seen[voxel] != 0 && classes[voxel] == VoxelMap.Enclosed))
        {
            yield return $"map of voxels '{label.Visible}' has a voxel that is seen where '{label.File}' says that it is enclosed.";
        }
    }

    private static bool IsObject(ushort value) =>
        value <= SemanticClasses.Greatest && SemanticClasses.ObjectOf((SemanticClass)value) is not null;
}
