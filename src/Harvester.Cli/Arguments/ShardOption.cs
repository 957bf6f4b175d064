using System.CommandLine;
using System.Globalization;
using Harvester.Datasets.Exports;

namespace Harvester.Cli.Arguments;

/// <summary>The option that makes a job one of several, the same wherever a command has it.</summary>
internal static class ShardOption
{
    public static Option<Shard> Create()
    {
        Option<Shard> option = ValueParsers.Parsed("--shard", "I/N", "Do every N-th frame only, as the I-th of N runs side by side", Parse, "a shard as 1/8");
        option.DefaultValueFactory = _ => Shard.Whole;
        return option;
    }

    private static Shard? Parse(string text)
    {
        string[] words = text.Split('/');
        return words.Length == 2
            && int.TryParse(words[0], NumberStyles.None, CultureInfo.InvariantCulture, out int number)
            && int.TryParse(words[1], NumberStyles.None, CultureInfo.InvariantCulture, out int count)
            && number >= 1 && number <= count
            ? new Shard(number, count)
            : null;
    }
}
