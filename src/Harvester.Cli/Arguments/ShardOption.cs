using System.CommandLine;
using Harvester.Datasets.Sessions;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Arguments;

/// <summary>The option that makes a job one of several, the same wherever a command has it.</summary>
internal static class ShardOption
{
    public static Option<Shard> Create()
    {
        Option<Shard> option = ValueParsers.Parsed("--shard", "I/N", "Process only every N-th frame, as run I of N parallel runs",
            ShardText.Parse, "a shard, e.g. 1/8");
        option.DefaultValueFactory = _ => Shard.Whole;
        return option;
    }
}
