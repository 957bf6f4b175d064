using System.CommandLine;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Arguments;

/// <summary>The option that makes a job one of several, the same wherever a command has it.</summary>
internal static class ShardOption
{
    public static Option<Shard> Create()
    {
        Option<Shard> option = ValueParsers.Parsed("--shard", "I/N", "Do every N-th frame only, as the I-th of N runs side by side", ShardText.Parse, "a shard as 1/8");
        option.DefaultValueFactory = _ => Shard.Whole;
        return option;
    }
}
