using Harvester.Cli.Terminals;
using Harvester.Datasets.Outputs;
using Harvester.Sessions.Files;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Terminals;

public sealed class OutputDiskTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Check_leaves_nothing_behind()
    {
        OutputDisk.Check(_folder.PathOf("a/b/c"), "--out");

        Assert.Empty(Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Existing_folder_stays()
    {
        Directory.CreateDirectory(_folder.PathOf("a"));

        OutputDisk.Check(_folder.PathOf("a"), "--out");

        Assert.True(Directory.Exists(_folder.PathOf("a")));
    }

    [Fact]
    public void Too_little_space_is_found() =>
        Assert.Throws<LowSpaceException>(() => OutputDisk.Check(_folder.PathOf("a"), "--out", minFreeBytes: long.MaxValue));

    /// <summary>Before a town is built or labels are read, so that nothing of a result is said.</summary>
    [PosixTheory]
    [InlineData("harvest --frames 1 --out /proc/harvester-test")]
    [InlineData("plan run PLAN --out /proc/harvester-test")]
    [InlineData("drive --duration 10 --out /proc/harvester-test")]
    public void Place_where_nothing_can_be_written_is_named(string command)
    {
        if (!OperatingSystem.IsLinux())
        {
            return;
        }

        string plan = _folder.PathOf("plan.json");
        CliRun.Of("plan", "init", plan);

        CliRun
            .Of([.. command.Split(' ').Select(word => word == "PLAN" ? plan : word)])
            .AssertFailed(
                ExitCode.InputOutput,
                "Nothing can be written to '/proc/harvester-test'. Change the permissions, or name another folder with --out."
            );
    }

    [Theory]
    [InlineData("harvest", "--frames", "1", "--out", "OUT")]
    [InlineData("plan", "run", "PLAN", "--out", "OUT")]
    [InlineData("drive", "--duration", "10", "--out", "DRIVE", "--record", "OUT")]
    public void Little_free_space_is_found_first(params string[] command)
    {
        string plan = _folder.PathOf("plan.json");
        File.WriteAllText(plan, """{"name":"p","places":[{"name":"a","spread":2}],"frames":1}""");
        string[] words =
        [
            .. command.Select(word =>
                word switch
                {
                    "OUT" => _folder.PathOf("out"),
                    "DRIVE" => _folder.PathOf("drive"),
                    "PLAN" => plan,
                    _ => word,
                }
            ),
            "--min-free",
            "900000TB",
        ];

        CliRun run = CliRun.Of(words);

        run.AssertFailed(ExitCode.InputOutput, "stay free");
        Assert.Equal("", run.Out);
        Assert.False(Directory.Exists(_folder.PathOf("out")));
    }
}
