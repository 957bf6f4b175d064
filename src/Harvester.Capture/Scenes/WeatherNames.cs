using System.Collections.Generic;
using System.Linq;
using Harvester.Capture.Spaces;

namespace Harvester.Capture.Scenes;

/// <summary>The game's names of weathers, by their hashes.</summary>
public static class WeatherNames
{
    private static readonly Dictionary<int, string> Known =
        "extrasunny clear clouds smog foggy overcast rain thunder clearing neutral snow blizzard snowlight xmas halloween"
            .Split(' ')
            .ToDictionary(ModelHash.Of);

    /// <summary>Whether a name is one of the game's, in small letters.</summary>
    public static bool IsKnown(string name) => Known.ContainsValue(name);

    /// <summary>The name of a weather; "unknown" for one that is not the game's own.</summary>
    public static string Of(int hash) => Known.TryGetValue(hash, out string? name) ? name : "unknown";
}
