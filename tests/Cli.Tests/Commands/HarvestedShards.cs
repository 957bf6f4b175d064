using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>One small harvest as a whole and in three shards, and a shard of another, for all tests of merging.</summary>
public sealed class HarvestedShards : IDisposable
{
    private static readonly string[] Options =
    [
        "--frames",
        "8",
        "--seed",
        "5",
        "--size",
        "160x120",
        "--masks",
        "--hz",
        "4",
        "--quirks",
        "creep=3,vanish=0.02",
        "--places",
        "3",
    ];

    private readonly TemporaryFolder _folder = new();

    public HarvestedShards()
    {
        Harvest("whole/session");
        Harvest("part-1", "--shard", "1/3");
        Harvest("part-2", "--shard", "2/3");
        Harvest("part-3", "--shard", "3/3");
        Harvest("other-3", "--shard", "3/3", "--range", "60");
    }

    public void Dispose() => _folder.Dispose();

    public string PathOf(string name) => _folder.PathOf(name);

    private void Harvest(string name, params string[] more) =>
        Assert.Equal(ExitCode.Done, CliRun.Of(["harvest", "--out", PathOf(name), .. Options, .. more]).ExitCode);
}
