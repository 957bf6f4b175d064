using System.Globalization;
using Harvester.Sessions.Files;

namespace Harvester.Sessions.Reading;

/// <summary>Parses shards, such as 2/8.</summary>
public static class ShardText
{
    /// <summary>The shard that a text describes; null if it is not a shard.</summary>
    public static Shard? Parse(string text)
    {
        string[] words = text.Split('/');
        return
            words.Length == 2
            && int.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            && int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out int count)
            && number >= 1
            && number <= count
            ? new Shard(number, count)
            : null;
    }
}
