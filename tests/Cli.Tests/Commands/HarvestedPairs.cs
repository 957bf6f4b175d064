namespace Harvester.Cli.Tests.Commands;

/// <summary>A small harvest with further pictures of each moment, as a whole and in two shards.</summary>
public sealed class HarvestedPairs : IDisposable
{
    public const string Options =
        "--frames 4 --size 96x72 --hz 2 --seed 4 --masks --no-report --pair-weathers clear,rain --pair-hours 0,12 "
        + "--pair-without nearest-vehicle,people --pair-ticks 60";

    private readonly TemporaryFolder _folder = new();

    public HarvestedPairs()
    {
        Harvest("session");
        Harvest("part-1", "--shard", "1/2");
        Harvest("part-2", "--shard", "2/2");
    }

    public string Session => PathOf("session");

    public void Dispose() => _folder.Dispose();

    public string PathOf(string name) => _folder.PathOf(name);

    private void Harvest(string name, params string[] more) =>
        CliRun.Of(["harvest", "--out", PathOf(name), .. Options.Split(' '), .. more]).AssertDone();
}
