using System.Diagnostics;
using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests;

/// <summary>Behaviour that needs a process of its own: signals, the bytes of arguments, the current folder.</summary>
public sealed class ProcessTests : IDisposable
{
    private static readonly TimeSpan GenerousDeadline = TimeSpan.FromMinutes(1);
    private static readonly string Program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [PosixTheory]
    [Trait("Category", "Heavy")]
    [InlineData("TERM", 143)]
    [InlineData("INT", 130)]
    public void Signal_ends_a_command_with_its_exit_code(string signal, int code)
    {
        using Process serve = Start(HeededSignals.Script + "exec $heeding dotnet \"$0\" serve --port 0 --traffic 0 --size 80x60", Program);
        Assert.StartsWith("Serving at ", serve.StandardOutput.ReadLine(), StringComparison.Ordinal);
        using Process kill = Start("kill -\"$0\" \"$1\"", signal, serve.Id.ToString(CultureInfo.InvariantCulture));

        try
        {
            Assert.True(serve.WaitForExit(GenerousDeadline), HeededSignals.NotEnded);
        }
        finally
        {
            serve.Kill();
        }

        Assert.Equal(code, serve.ExitCode);
    }

    [PosixTheory]
    [Trait("Category", "Heavy")]
    [InlineData("TERM")]
    [InlineData("INT")]
    public void Forced_stop_leaves_no_lock(string signal)
    {
        // A frame of this size takes many seconds; after the first signal alone, it would be finished and counted.
        using Process harvest = Start(
            HeededSignals.Script + "exec $heeding dotnet \"$0\" harvest --out out --frames 2 --size 3840x2160 --masks --no-report",
            Program
        );
        Assert.StartsWith("Harvesting ", harvest.StandardOutput.ReadLine(), StringComparison.Ordinal);
        Assert.Equal([".out.harvester-lock", ".out.harvester-lock.txt"], Locks());
        using Process kill = Start(
            "kill -\"$0\" \"$1\"; sleep 0.2; kill -\"$0\" \"$1\"",
            signal,
            harvest.Id.ToString(CultureInfo.InvariantCulture)
        );

        try
        {
            Assert.True(harvest.WaitForExit(GenerousDeadline), HeededSignals.NotEnded);
        }
        finally
        {
            harvest.Kill();
        }

        Assert.Equal("", harvest.StandardError.ReadToEnd());
        Assert.Equal(signal == "INT" ? ExitCode.Cancelled : ExitCode.Terminated, harvest.ExitCode);
        Assert.Empty(Locks());

        string[] Locks() => [.. Directory.EnumerateFiles(_folder.Path, "*harvester-lock*").Select(path => Path.GetFileName(path)).Order()];
    }

    [PosixFact]
    public void Folder_name_that_is_not_utf_8_is_refused_without_output()
    {
        using Process harvest = Start("exec dotnet \"$0\" harvest --frames 1 --out \"$(printf 'caf\\351')\"", Program);
        string error = harvest.StandardError.ReadToEnd();
        harvest.WaitForExit();

        Assert.Equal(ExitCode.Usage, harvest.ExitCode);
        Assert.Contains("is not valid UTF-8", error, StringComparison.Ordinal);
        Assert.Empty(Directory.EnumerateFileSystemEntries(_folder.Path));
    }

    [PosixFact]
    public void Gallery_of_a_table_is_written_to_the_current_folder()
    {
        string data = Directory.CreateDirectory(_folder.PathOf("data")).FullName;
        File.WriteAllText(
            Path.Combine(data, "spaces.csv"),
            "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test\n"
        );
        using Process gallery = Start("exec dotnet \"$0\" spaces gallery data/spaces.csv", Program);
        gallery.WaitForExit();

        Assert.Equal(ExitCode.Done, gallery.ExitCode);
        Assert.Equal(["spaces.csv"], Directory.EnumerateFileSystemEntries(data).Select(Path.GetFileName));
        Assert.True(File.Exists(_folder.PathOf("gallery.html")));
    }

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Harvest_gives_the_same_bytes_on_one_core_and_on_two() =>
        AssertSameBytesOnOneCoreAndOnTwo("--masks --quirks lag=2,vanish=0.1 --weather rain");

    [PosixFact]
    [Trait("Category", "Heavy")]
    public void Plain_harvest_gives_the_same_bytes_on_one_core_and_on_two() => AssertSameBytesOnOneCoreAndOnTwo("");

    private void AssertSameBytesOnOneCoreAndOnTwo(string options)
    {
        string[] sessions = ["1", "2"];
        foreach (string cores in sessions)
        {
            using Process harvest = Start(
                $"DOTNET_PROCESSOR_COUNT={cores} exec dotnet \"$0\" harvest --seed 4 --frames 6 --size 160x120 --no-report --quiet "
                    + $"--out {cores} {options}",
                Program
            );
            harvest.WaitForExit();
            Assert.Equal(ExitCode.Done, harvest.ExitCode);
        }

        Dictionary<string, byte[]>[] files = [.. sessions.Select(name => FilesOf(_folder.PathOf(name)))];
        Assert.NotEmpty(files[0]);
        Assert.Equal(files[0], files[1]);
    }

    private static Dictionary<string, byte[]> FilesOf(string folder) =>
        Directory
            .EnumerateFiles(folder, "*", SearchOption.AllDirectories)
            .ToDictionary(path => Path.GetRelativePath(folder, path), File.ReadAllBytes);

    private Process Start(string script, params string[] arguments)
    {
        var start = new ProcessStartInfo("/bin/sh")
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            WorkingDirectory = _folder.Path,
        };
        Array.ForEach(["-c", script, .. arguments], start.ArgumentList.Add);
        return Process.Start(start)!;
    }
}
