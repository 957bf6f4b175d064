using System.Collections.Generic;
using System.Linq;

namespace Harvester.Sessions.Scenes;

/// <summary>The game's names of weathers, in small letters.</summary>
public static class WeatherNames
{
    private static readonly string[] Names =
        "clear extrasunny clouds neutral overcast smog foggy clearing rain thunder snowlight snow xmas blizzard halloween".Split(' ');

    private static readonly Dictionary<int, string> Known = Names.ToDictionary(ModelHash.Of);

    /// <summary>All names, as the game spells them.</summary>
    public static IReadOnlyList<string> All => Names;

    /// <summary>Whether a name is one of them.</summary>
    public static bool IsKnown(string name) => Names.Contains(name);

    /// <summary>The name of the weather with a hash; "unknown" for one that is not the game's own.</summary>
    public static string Of(int hash) => Known.TryGetValue(hash, out string? name) ? name : "unknown";
}
