namespace Harvester.Sessions.Scenes;

/// <summary>The game's names of weathers, in lower case.</summary>
public static class WeatherNames
{
    private static readonly string[] Names =
        "clear extrasunny clouds neutral overcast smog foggy clearing rain thunder snowlight snow xmas blizzard halloween".Split(' ');

    private static readonly Dictionary<int, string> Known = Names.ToDictionary(ModelHash.Of);

    /// <summary>All names, in lower case.</summary>
    public static IReadOnlyList<string> All => Names;

    /// <summary>Whether the game has a weather of this name.</summary>
    public static bool IsKnown(string name) => Names.Contains(name);

    /// <summary>The name of a weather that is written in upper or lower case; null for an unknown one.</summary>
    public static string? Find(string name) => Array.Find(Names, each => each.Equals(name, StringComparison.OrdinalIgnoreCase));

    /// <summary>The name of the weather with a hash; "unknown" for an unknown hash.</summary>
    public static string Of(int hash) => Known.TryGetValue(hash, out string? name) ? name : "unknown";
}
