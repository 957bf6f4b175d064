using System.CommandLine;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Cli.Arguments;

/// <summary>--shard: runs one of several parallel parts of a job. Several commands share it.</summary>
internal static class ShardOption
{
    /// <summary>What to do when a shard is done.</summary>
    public const string NextStep = "When all shards are done, merge them: harvester merge SHARD... --out DIR";

    public static Option<Shard> Create(string description = "Process only every N-th frame, as run I of N parallel runs")
    {
        Option<Shard> option = ValueParsers.Parsed("--shard", "I/N", description, ShardText.Parse, "I/N with I from 1 to N, e.g. 1/8");
        option.DefaultValueFactory = _ => Shard.Whole;
        return option;
    }
}
