using System.Text.RegularExpressions;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class StatsCommandTests
{
    [Fact]
    public void Statistics_cover_all_sessions_together()
    {
        using var folder = new TemporaryFolder();
        folder.File(
            "session.json",
            """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }"""
        );

        CliRun run = CliRun.Of("stats", folder.Path, folder.Path);

        Assert.Equal(ExitCode.Done, run.ExitCode);
        Assert.Contains(
            "\nwithout signs, traffic lights and riders, which KITTI does not label by themselves: 0 labels, 0.0 labels per frame\n",
            run.Out,
            StringComparison.Ordinal
        );
        Assert.Contains("\ndistance, m: none\n", run.Out, StringComparison.Ordinal);
        Assert.StartsWith(
            "0 frames, 0 labels, 0.0 labels per frame\nKITTI object detection, for comparison: 7481 training and 7518 test images, ",
            run.Out,
            StringComparison.Ordinal
        );
    }

    [Fact]
    public void Bins_show_both_ends_and_the_last_one_is_open()
    {
        using var folder = new TemporaryFolder();
        SharedHarvest.CopyTo(folder.PathOf("session"), "--frames", "3", "--seed", "5", "--size", "80x60", "--no-report");
        string labels = folder.PathOf("session/labels.jsonl");
        File.WriteAllText(labels, new Regex("\"distanceMetres\":[0-9.]+").Replace(File.ReadAllText(labels), "\"distanceMetres\":400", 1));

        CliRun run = CliRun.Of("stats", folder.PathOf("session"));

        Assert.Matches(@"\ndistance, m: (\d+-\d+: \d+, )*150 or more: 1\n", run.Out);
        Assert.Matches(@"\nocclusion: 0-0\.1: \d+", run.Out);
    }

    [Fact]
    public void Missing_folder_is_an_input_error() =>
        CliRun.Of("stats", "no-such-session").AssertFailed(ExitCode.InputOutput, "no-such-session");
}
