using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Labels;

namespace Harvester.Datasets.Validation;

/// <summary>Checks the bird's-eye map of a frame: every cell has a class and is seen or not.</summary>
internal static class BirdsEyeCheck
{
    /// <summary>What is wrong with the maps, one line each.</summary>
    /// <param name="label">What the label says of them.</param>
    /// <param name="read">Reads a map of the session.</param>
    /// <exception cref="Harvester.Sessions.Reading.Files.DatasetFormatException">A map cannot be read.</exception>
    public static IEnumerable<string> Problems(BirdsEyeLabel label, Func<string, InstanceMap> read)
    {
        if (StrayIn(read(label.File), static value => value <= (int)BirdsEyeClass.Person) is { } stray)
        {
            yield return $"bird's-eye map '{label.File}' has the value {stray}, which is no class. Classes are 0 to "
                + $"{(int)BirdsEyeClass.Person}.";
        }

        if (label.Visible is { } visible && StrayIn(read(visible), static value => value is 0 or BirdsEyeLabel.Seen) is { } other)
        {
            yield return $"bird's-eye map '{visible}' has the value {other}. Its cells are 0 or {BirdsEyeLabel.Seen}.";
        }
    }

    private static int? StrayIn(InstanceMap map, Func<int, bool> isKnown)
    {
        foreach (ushort value in map.Ids)
        {
            if (!isKnown(value))
            {
                return value;
            }
        }

        return null;
    }
}
