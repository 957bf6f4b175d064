using Harvester.Geometry.PixelMaps;
using Harvester.Sessions.Semantics;

namespace Harvester.Datasets.Validation;

/// <summary>Checks a class map: every value is a class.</summary>
internal static class ClassMapCheck
{
    private const int MaxNamedValues = 5;

    public static IEnumerable<string> Problems(string name, InstanceMap map)
    {
        ushort[] strays = [.. map.Ids.Where(value => value > SemanticClasses.Greatest).Distinct().Order()];
        if (strays.Length > 0)
        {
            yield return $"class map '{name}' has values that are no classes: {string.Join(", ", strays.Take(MaxNamedValues))}"
                + $"{(strays.Length > MaxNamedValues ? $" and {strays.Length - MaxNamedValues} more" : "")}. Classes are 0 to "
                + $"{SemanticClasses.Greatest}.";
        }
    }
}
