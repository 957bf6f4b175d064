using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestDetailTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Labels_and_masks_do_not_depend_on_detail()
    {
        string plain = Harvest("plain");
        string full = Harvest("full");

        Assert.Equal(File.ReadAllText(Path.Combine(plain, "labels.jsonl")), File.ReadAllText(Path.Combine(full, "labels.jsonl")));
        string[] masks = [.. Directory.GetFiles(Path.Combine(plain, "masks")).Order(StringComparer.Ordinal)];
        Assert.Equal(4, masks.Length);
        foreach (string mask in masks)
        {
            string name = Path.GetFileName(mask);
            Assert.Equal(File.ReadAllBytes(mask), File.ReadAllBytes(Path.Combine(full, "masks", name)));
            Assert.NotEqual(File.ReadAllBytes(Path.Combine(plain, "frames", name)), File.ReadAllBytes(Path.Combine(full, "frames", name)));
        }
    }

    public void Dispose() => _folder.Dispose();

    private string Harvest(string detail)
    {
        string folder = _folder.PathOf($"{detail}");
        CliRun run = CliRun.Of(
            "harvest",
            "--out",
            folder,
            "--frames",
            "4",
            "--places",
            "2",
            "--size",
            "160x120",
            "--masks",
            "--seed",
            "3",
            "--time",
            "22:00",
            "--weather",
            "rain",
            "--detail",
            detail
        );
        Assert.Equal(ExitCode.Done, run.ExitCode);
        return folder;
    }
}
