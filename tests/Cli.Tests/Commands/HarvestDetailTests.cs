using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Commands;

public sealed class HarvestDetailTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    [Theory]
    [InlineData("12:00", "clear")]
    [InlineData("22:00", "rain")]
    public void Labels_and_masks_do_not_depend_on_detail(string time, string weather)
    {
        string plain = Harvest("plain", time, weather);
        string full = Harvest("full", time, weather);

        Assert.Equal(File.ReadAllText(Path.Combine(plain, "labels.jsonl")), File.ReadAllText(Path.Combine(full, "labels.jsonl")));
        string[] masks = [.. Directory.GetFiles(Path.Combine(plain, "masks")).Order(StringComparer.Ordinal)];
        Assert.Equal(4, masks.Length);
        foreach (string mask in masks)
        {
            string name = Path.GetFileName(mask);
            Assert.Equal(File.ReadAllBytes(mask), File.ReadAllBytes(Path.Combine(full, "masks", name)));
            Assert.NotEqual(
                File.ReadAllBytes(Path.Combine(plain, "frames", name)), File.ReadAllBytes(Path.Combine(full, "frames", name)));
        }
    }

    public void Dispose() => _folder.Dispose();

    private string Harvest(string detail, string time, string weather)
    {
        string folder = _folder.PathOf($"{detail}");
        CliRun run = CliRun.Of(
            "harvest", "--out", folder, "--frames", "4", "--places", "2", "--size", "160x120", "--masks", "--seed", "3",
            "--time", time, "--weather", weather, "--detail", detail);
        Assert.Equal(ExitCode.Done, run.ExitCode);
        return folder;
    }
}
