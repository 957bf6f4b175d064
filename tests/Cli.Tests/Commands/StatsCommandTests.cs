using System.Text.RegularExpressions;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class StatsCommandTests
{
    [Fact]
    public void Stats_of_sessions_counts_them_together()
    {
        using var folder = new TemporaryFolder();
        folder.File("session.json", """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }""");

        CliRun run = CliRun.Of("stats", folder.Path, folder.Path);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains("without which there are 0 labels here, 0.0 a frame\n", run.Out, StringComparison.Ordinal);
        Assert.Contains("\ndistance, m: none\n", run.Out, StringComparison.Ordinal);
        Assert.StartsWith("0 frames, 0 labels, 0.0 a frame\nfor comparison, KITTI object detection: 7481 images", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Stats_name_both_ends_of_a_bin_and_count_what_lies_above()
    {
        using var folder = new TemporaryFolder();
        CliRun.Of("harvest", "--out", folder.PathOf("session"), "--frames", "3", "--seed", "5", "--size", "80x60", "--no-report");
        string labels = folder.PathOf("session/labels.jsonl");
        File.WriteAllText(labels, new Regex("\"distanceMetres\":[0-9.]+").Replace(File.ReadAllText(labels), "\"distanceMetres\":400", 1));

        CliRun run = CliRun.Of("stats", folder.PathOf("session"));

        Assert.Matches(@"\ndistance, m: (\d+-\d+: \d+, )*150 or more: 1\n", run.Out);
        Assert.Matches(@"\noccluded fraction: 0-0\.1: \d+", run.Out);
    }

    [Fact]
    public void Stats_of_no_folder_is_an_input_error() =>
        CliRun.Of("stats", "no-such-session").AssertFailed(ExitCode.InputOutput, "no-such-session");
}
