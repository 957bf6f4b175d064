using System.Diagnostics;
using Harvester.Cli.Terminals;
using Harvester.Driving.Bridge;
using Harvester.Geometry.Cameras;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Processes that write to one folder at the same time.</summary>
public sealed class TwoWritersTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    [Trait("Category", "Heavy")]
    public void Second_writer_is_refused_until_the_first_is_killed()
    {
        using Process first = Start("100000");
        try
        {
            string labels = _folder.PathOf("out/labels.jsonl");
            Await(() => File.Exists(labels) && new FileInfo(labels).Length > 0, first);

            using Process second = Start("1", "--overwrite");
            string error = second.StandardError.ReadToEnd();
            second.WaitForExit();

            Assert.Equal(ExitCode.Usage, second.ExitCode);
            Assert.StartsWith(
                $"harvester: '{_folder.PathOf("out")}' is being written by another harvester "
                    + $"(process {first.Id} on {Environment.MachineName} since ",
                error,
                StringComparison.Ordinal
            );
            Assert.Equal(1, error.Count(character => character == '\n'));
            Assert.False(first.HasExited);
        }
        finally
        {
            first.Kill();
            first.WaitForExit();
        }

        CliRun third = CliRun.Of([.. Arguments("1"), "--overwrite"]);

        Assert.Equal((ExitCode.Done, ""), (third.ExitCode, third.Error));
        Assert.Equal([_folder.PathOf("out")], Directory.GetFileSystemEntries(_folder.Path));
        Assert.Single(File.ReadLines(_folder.PathOf("out/labels.jsonl")));
    }

    [Fact]
    public void Second_game_over_a_shared_folder_is_refused()
    {
        string folder = _folder.PathOf("shared");
        using var bridge = new FolderBridge(folder, new ImageSize(80, 60));

        CliRun
            .Of("serve", "--folder", folder, "--duration", "0.1", "--traffic", "0", "--size", "80x60")
            .AssertFailed(ExitCode.Usage, $"is being written by another harvester (process {Environment.ProcessId} on ");
    }

    [Fact]
    public void Game_over_a_shared_folder_releases_it_at_its_end()
    {
        string folder = _folder.PathOf("shared");
        for (int i = 0; i < 2; i++)
        {
            CliRun run = CliRun.Of("serve", "--folder", folder, "--duration", "0.1", "--traffic", "0", "--size", "80x60");
            Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        }

        Assert.Equal([folder], Directory.GetFileSystemEntries(_folder.Path));
    }

    [Fact]
    public void Command_that_is_refused_leaves_neither_a_lock_nor_a_folder()
    {
        string[] arguments = ["harvest", "--out", _folder.PathOf("not/there"), "--frames", "1", "--roads", _folder.PathOf("missing.csv")];

        Assert.NotEqual(ExitCode.Done, CliRun.Of(arguments).ExitCode);

        Assert.Empty(Directory.GetFileSystemEntries(_folder.Path));
    }

    private static void Await(Func<bool> isThere, Process process)
    {
        DateTime end = DateTime.UtcNow.AddMinutes(2);
        while (!isThere())
        {
            Assert.False(process.HasExited, "The first writer has ended.");
            Assert.True(DateTime.UtcNow < end, "The first writer has written nothing.");
            Thread.Sleep(20);
        }
    }

    private string[] Arguments(string frames) =>
        ["harvest", "--out", _folder.PathOf("out"), "--frames", frames, "--size", "64x48", "--no-report", "--quiet"];

    private Process Start(string frames, params string[] more)
    {
        var start = new ProcessStartInfo("dotnet") { RedirectStandardError = true };
        string[] words = [Path.Combine(AppContext.BaseDirectory, "harvester.dll"), .. Arguments(frames), .. more];
        Array.ForEach(words, start.ArgumentList.Add);
        return Process.Start(start)!;
    }
}
