using System;
using System.Collections.Generic;
using System.Linq;
using Harvester.Sessions.Text;

namespace Harvester.Datasets.Json;

/// <summary>Reads the names of enumeration values in files.</summary>
public static class JsonNames
{
    /// <summary>The names of all values, in the order of the enumeration.</summary>
    public static IEnumerable<string> All<T>()
        where T : struct, Enum =>
        Enum.GetValues<T>().Select(JsonName.Of);

    /// <summary>Reads a name; case-sensitive.</summary>
    public static bool TryRead<T>(string name, out T value)
        where T : struct, Enum
    {
        foreach (T candidate in Enum.GetValues<T>())
        {
            if (string.Equals(JsonName.Of(candidate), name, StringComparison.Ordinal))
            {
                value = candidate;
                return true;
            }
        }

        value = default;
        return false;
    }
}
