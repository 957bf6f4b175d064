using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests;

public sealed class QuietTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("--quiet")]
    [InlineData("-q")]
    public void Quiet_harvest_prints_nothing_and_writes_its_session(string option)
    {
        CliRun run = CliRun.Of("harvest", "--out", _folder.PathOf("out"), "--frames", "1", "--size", "64x48", "--no-report", option);

        Assert.Equal((ExitCode.Done, "", ""), (run.ExitCode, run.Out, run.Error));
        Assert.Single(File.ReadLines(_folder.PathOf("out/labels.jsonl")));
    }

    [Fact]
    public void Quiet_command_still_names_its_error() =>
        CliRun.Of("harvest", "--quiet", "--out", _folder.Path, "--frames", "0").AssertFailed(ExitCode.Usage, "--frames");

    [Fact]
    public void Quiet_command_still_prints_its_result()
    {
        CliRun run = CliRun.WithInput(
            "0,10,0\n",
            "project",
            "-q",
            "--position",
            "0,0,0",
            "--rotation",
            "0,0,0",
            "--fov",
            "90",
            "--size",
            "800x600"
        );

        Assert.Equal("u,v,depth,outcome\n400,300,10,inImage\n", run.Out);
    }

    [Theory]
    [InlineData("harvester har", "harvest")]
    [InlineData("harvester harvest --fr", "--frames")]
    [InlineData("harvester roads c", "compare")]
    public void Completion_lists_the_possible_next_words(string line, string expected)
    {
        string typed = line["harvester ".Length..];
        CliRun run = CliRun.Of($"[suggest:{typed.Length}]", typed);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.Contains(expected, run.Out.Split('\n'));
    }
}
