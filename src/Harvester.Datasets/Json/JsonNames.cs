using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.Json;

namespace Harvester.Datasets.Json;

/// <summary>The names of enumerations as files have them: with a small first letter.</summary>
public static class JsonNames
{
    /// <summary>The name of a value.</summary>
    public static string Of<T>(T value)
        where T : struct, Enum =>
        JsonNamingPolicy.CamelCase.ConvertName(value.ToString());

    /// <summary>The names of all values, in the order of the enumeration.</summary>
    public static IEnumerable<string> All<T>()
        where T : struct, Enum =>
        Enum.GetValues<T>().Select(Of);

    /// <summary>Reads a name; capitals matter.</summary>
    public static bool TryRead<T>(string name, out T value)
        where T : struct, Enum
    {
        foreach (T candidate in Enum.GetValues<T>())
        {
            if (string.Equals(Of(candidate), name, StringComparison.Ordinal))
            {
                value = candidate;
                return true;
            }
        }

        value = default;
        return false;
    }
}
