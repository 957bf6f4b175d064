using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Commands;

public sealed class DoctorCommandTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Problem_is_reported_with_cause_advice_and_line()
    {
        string log = Write("2026-10-02 18:03:11 The harvest ended: 0 frames, discarded: 50 black, in out.\n");
        CliRun run = CliRun.Of("doctor", log);

        Assert.Equal((ExitCode.BadData, ""), (run.ExitCode, run.Error));
        Assert.Equal(
            $"""
            Read {log}: 1 line

            1. The images were black or of a single colour: the game runs in exclusive full screen, or its window cannot be copied.
               What to do: Choose windowed borderless in the game's graphics settings.
               Seen in GtaDataHarvester.log line 1: 2026-10-02 18:03:11 The harvest ended: 0 frames, discarded: 50 black, in out.

            1 problem found in {log}

            """.ReplaceLineEndings("\n"),
            run.Out
        );
    }

    [Fact]
    public void Log_without_a_problem_is_reported_as_good()
    {
        string log = Write("2026-10-02 18:03:11 The test car is here.\n");
        CliRun run = CliRun.Of("doctor", log);

        Assert.Equal((ExitCode.Done, ""), (run.ExitCode, run.Error));
        Assert.EndsWith($"No problem found in {log}\n", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Earlier_runs_are_examined_on_request()
    {
        const string begin = "2026-10-02 18:03:11 GtaDataHarvester 0.1.0.0, API 3.6.0.0, GTA V Legacy 1.0.3179.0.\n";
        string log = Write(begin + "2026-10-02 18:03:11 The harvest: on\n" + begin);

        Assert.Contains("1 line, 1 earlier run skipped", CliRun.Of("doctor", log).Out, StringComparison.Ordinal);
        Assert.Contains("1 problem found", CliRun.Of("doctor", log, "--all-runs").Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Control_characters_of_a_log_do_not_reach_the_terminal()
    {
        string log = Write("2026-10-02 18:03:11 The overlay failed: \u001b[2J gone. More in GtaDataHarvester.log.\n");

        Assert.DoesNotContain('\u001b', CliRun.Of("doctor", log).Out);
    }

    [Fact]
    public void Unreadable_log_is_refused_in_one_line()
    {
        CliRun.Of("doctor", Path.Combine(_folder.Path, "missing.log")).AssertFailed(ExitCode.InputOutput, "missing.log");
        CliRun
            .Of("doctor", _folder.Path)
            .AssertFailed(ExitCode.BadData, "has no log of the mod, and is neither the game's folder nor a session");
        string notes = Path.Combine(_folder.Path, "notes.txt");
        File.WriteAllText(notes, "milk\n");
        CliRun.Of("doctor", notes).AssertFailed(ExitCode.BadData, "is not a log of the mod, ScriptHookVDotNet or ScriptHookV");
    }

    private string Write(string text)
    {
        string path = Path.Combine(_folder.Path, "GtaDataHarvester.log");
        File.WriteAllText(path, text);
        return path;
    }
}
