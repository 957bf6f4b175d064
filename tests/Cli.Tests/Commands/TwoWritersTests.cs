using System.Diagnostics;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

/// <summary>Processes that write to one folder at the same time.</summary>
public sealed class TwoWritersTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
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
                StringComparison.Ordinal);
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
