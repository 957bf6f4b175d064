using System.Diagnostics;
using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.Play.Tapes;
using Harvester.TestSupport;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>One signal ends a command, whatever it is reading: a pipe that stays empty, a stream without end, a huge file.</summary>
[Trait("Category", "Heavy")]
public sealed class SignalTests(HugeSession session) : IClassFixture<HugeSession>, IDisposable
{
    /// <summary>
    /// The program gives a command 5 s to end by itself. The rest is for a machine that does other work; a command that hangs needs more.
    /// </summary>
    private static readonly TimeSpan GenerousDeadline = TimeSpan.FromMinutes(1);

    private static readonly string Program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
    private readonly TemporaryFolder _folder = new();
    private volatile bool _hasOutput;

    public void Dispose() => _folder.Dispose();

    [PosixTheory]
    [InlineData("TERM", "validate SESSION")]
    [InlineData("INT", "validate SESSION")]
    [InlineData("TERM", "stats SESSION")]
    [InlineData("TERM", "report SESSION --out OUT.html")]
    [InlineData("TERM", "report SESSION --still 19999 --out OUT.png")]
    [InlineData("TERM", "masks import SESSION SESSION/masks")]
    [InlineData("TERM", "relabel SESSION --no-report --out OUT")]
    [InlineData("TERM", "repair SESSION --out OUT")]
    [InlineData("TERM", "export SESSION --format coco --out OUT")]
    [InlineData("TERM", "export SESSION --format webdataset --out OUT")]
    [InlineData("TERM", "roads info ROADS")]
    [InlineData("TERM", "roads map ROADS --out OUT.svg")]
    [InlineData("TERM", "harvest --frames 1000000 --size 80x60 --no-report --out OUT --roads ROADS")]
    [InlineData("TERM", "serve --port 0 --roads ROADS")]
    [InlineData("TERM", "contact-sheet --roads ROADS --out OUT.png")]
    [InlineData("TERM", "lanes --roads ROADS --position 0,0,0 --heading 0")]
    public void Signal_ends_a_command_that_reads_a_huge_file(string signal, string command)
    {
        using Process process = Start(command, "");
        Await(() => process.HasExited || !OperatingSystem.IsLinux() || Reads(process, session.Path), "the file to be read");

        AssertEnds(process, signal);
    }

    [PosixTheory]
    [InlineData("TERM", "harvest --frames 1000000 --size 80x60 --no-report --out OUT", "labels.jsonl")]
    [InlineData("INT", "harvest --frames 1000000 --size 80x60 --no-report --out OUT", "labels.jsonl")]
    [InlineData("TERM", "drive --duration 100000 --out OUT", "")]
    public void Signal_ends_a_command_that_writes(string signal, string command, string file)
    {
        using Process process = Start(command, "");
        Await(() => process.HasExited || Path.Exists(_folder.PathOf(Path.Combine("out", file))), "the output");

        AssertEnds(process, signal);
    }

    [PosixTheory]
    [InlineData("TERM", "")]
    [InlineData("INT", "")]
    [InlineData("TERM", "yes 1,2,3 |")]
    public void Signal_ends_a_command_that_reads_a_stream_without_end(string signal, string source)
    {
        const string command = "project --position 0,0,0 --rotation 0,0,0 --fov 50 --size 80x60";
        using Process process = Start(command, source);
        if (source.Length == 0)
        {
            // More than the pipe holds: when all is written, some of it has been read.
            process.StandardInput.Write(string.Concat(Enumerable.Repeat("1,2,3\n", 50_000)));
            process.StandardInput.Flush();
        }
        else
        {
            Await(() => _hasOutput, "the output");
        }

        AssertEnds(process, signal);
    }

    /// <summary>Its own temporary folder shows what a playback leaves.</summary>
    [PosixTheory]
    [InlineData("TERM")]
    [InlineData("INT")]
    public void Signal_ends_a_playback_that_leaves_nothing(string signal)
    {
        const int ticks = 999_000;
        string temporary = Directory.CreateDirectory(_folder.PathOf("temporary")).FullName;
        string tape = _folder.PathOf("long.tape");
        File.WriteAllBytes(tape, TapeBytes.Of([.. TapeBytes.Idle.SkipLast(1), .. Enumerable.Repeat(new TapeTick(), ticks)]));
        using Process process = Start($"tape play '{tape}'", "", temporary);
        Await(() => process.HasExited || Playing().Length > 0, "the playback");

        AssertEnds(process, signal);

        Assert.Empty(Playing());

        string[] Playing() => Directory.GetDirectories(temporary, "harvester-tape-*");
    }

    private static void AssertEnds(Process process, string signal)
    {
        // What ends before the signal comes proves nothing.
        Assert.False(process.HasExited, "It has ended by itself.");
        string group = process.Id.ToString(CultureInfo.InvariantCulture);
        using var kill = Process.Start("/bin/sh", ["-c", $"kill -{signal} {group}"]);
        try
        {
            Assert.True(process.WaitForExit(GenerousDeadline), HeededSignals.NotEnded);
        }
        finally
        {
            process.Kill(entireProcessTree: true);
        }

        Assert.Equal(signal == "TERM" ? ExitCode.Terminated : ExitCode.Cancelled, process.ExitCode);
    }

    private static bool Reads(Process process, string folder)
    {
        try
        {
            return Directory
                .EnumerateFiles($"/proc/{process.Id}/fd")
                .Any(file => new FileInfo(file).LinkTarget?.StartsWith(folder, StringComparison.Ordinal) == true);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    private static void Await(Func<bool> done, string what)
    {
        var waited = Stopwatch.StartNew();
        while (!done())
        {
            Assert.True(waited.Elapsed < GenerousDeadline, $"Waited in vain for {what}.");
            Thread.Sleep(5);
        }
    }

    private Process Start(string command, string source, string? temporary = null)
    {
        string words = command
            .Replace("SESSION", session.Session, StringComparison.Ordinal)
            .Replace("ROADS", session.Roads, StringComparison.Ordinal)
            .Replace("OUT", _folder.PathOf("out"), StringComparison.Ordinal);
        var start = new ProcessStartInfo("/bin/sh")
        {
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        if (temporary is not null)
        {
            start.Environment["TMPDIR"] = temporary;
        }

        string run = $"$heeding dotnet '{Program}' {words}";
        string stream = _folder.PathOf("stream");
        string script = source.Length == 0 ? $"exec {run}" : $"mkfifo '{stream}'; {source} cat >'{stream}' & exec {run} <'{stream}'";
        Array.ForEach(["-c", HeededSignals.Script + script], start.ArgumentList.Add);
        Process process = Process.Start(start)!;
        process.OutputDataReceived += (_, line) => _hasOutput |= line.Data is not null;
        process.ErrorDataReceived += static (_, _) => { };
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        return process;
    }
}
