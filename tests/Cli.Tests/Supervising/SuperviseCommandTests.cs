using System.Diagnostics;
using Harvester.Cli.Terminals;
using Harvester.Runs.Supervising;

namespace Harvester.Cli.Tests.Supervising;

/// <summary>A stand-in for a game that hangs, crashes and lies is started again until it finishes.</summary>
public sealed class SuperviseCommandTests : IDisposable
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(1);

    private readonly TemporaryFolder _folder = new();

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("crashes", "crashed: it ended (exit code 9) before its heartbeat said finished")]
    [InlineData("quits", "crashed: it ended (exit code 0) before its heartbeat said finished")]
    [InlineData("claims-other-process", "was ended: its heartbeat names process 1, which the command did not start")]
    [InlineData("claims-future", "s in the future")]
    [Trait("Category", "Heavy")]
    public void Program_that_crashes_or_lies_is_restarted(string behaviour, string reason) => AssertRestarted(behaviour, reason);

    [Theory]
    [InlineData("stalls", "it has been at frame 1 for 0.5 s", "--stall", "0.5")]
    [InlineData("hangs", "no new heartbeat for 1 s", "--timeout", "1")]
    [InlineData("leaves-daemon", "no new heartbeat for 1 s", "--timeout", "1")]
    [InlineData("writes-rubbish", "no heartbeat within 1 s. The file cannot be used: It has more than", "--start-timeout", "1")]
    [Trait("Category", "Heavy")]
    public void Program_that_hangs_or_stalls_is_restarted(string behaviour, string reason, string option, string value)
    {
        AssertRestarted(behaviour, reason, option, value);

        // The process that the one that hung had started is ended too.
        if (behaviour is ("hangs" or "leaves-daemon") && OperatingSystem.IsLinux())
        {
            Wait(() => IsEnded(File.ReadAllText(_folder.PathOf(StandIn.Helper)).Trim()), "the end of its helper");
        }
    }

    [Theory]
    [InlineData("leaves-daemon")]
    [InlineData("hangs")]
    [Trait("Category", "Heavy")]
    public async Task Helper_of_a_crashed_program_is_ended(string behaviour)
    {
        if (!OperatingSystem.IsLinux())
        {
            return;
        }

        Task<CliRun> run = CliRun.BesideAsync(Words(behaviour));
        Wait(() => HeartbeatReader.Read(_folder.PathOf("heartbeat.json")).Heartbeat is not null, "the heartbeat");
        SeenHeartbeat heartbeat = HeartbeatReader.Read(_folder.PathOf("heartbeat.json")).Heartbeat!;
        string helper = File.ReadAllText(_folder.PathOf(StandIn.Helper)).Trim();
        Signal("KILL", heartbeat.Process);

        (await run).AssertDone();
        Assert.True(IsEnded(helper));
    }

    /// <summary>
    /// A shell that SIGTERM ends leaves two children that ignore it, and one that has left its session with an empty environment.
    /// </summary>
    [Fact]
    [Trait("Category", "Heavy")]
    public void Stubborn_children_are_ended_with_the_supervisor()
    {
        if (!OperatingSystem.IsLinux())
        {
            return;
        }

        const string script = """
            cd "$0"
            for child in 1 2; do sh -c 'trap "" TERM INT; echo $$ > stubborn-'$child'; while :; do sleep 1; done' & done
            env -i /usr/bin/setsid /bin/sh -c '/bin/sleep 600 > /dev/null & echo $! > stubborn-3'
            printf '{"process": %d, "time": "%s", "state": "running", "trial": null, "frames": 1}' \
              $$ "$(date -u +%Y-%m-%dT%H:%M:%SZ)" > heartbeat.json
            while :; do sleep 1; done
            """;
        using Process supervisor = StartBeside("supervise", "--heartbeat", _folder.Path, "--", "sh", "-c", script, _folder.Path);
        Wait(() => File.Exists(_folder.PathOf("heartbeat.json")) && Directory.GetFiles(_folder.Path, "stubborn-*").Length == 3, "children");
        Signal("TERM", supervisor.Id);

        Assert.True(supervisor.WaitForExit(Patience), HeededSignals.NotEnded);
        Assert.Equal(ExitCode.Terminated, supervisor.ExitCode);
        Assert.All(Directory.GetFiles(_folder.Path, "stubborn-*"), file => Assert.True(IsEnded(File.ReadAllText(file).Trim()), file));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Program_that_always_crashes_is_given_up()
    {
        CliRun run = Supervise("crashes-always", "--max-restarts", "1");

        // The first start comes one frame further than nothing, which is progress; the next two do not.
        Assert.Equal(ExitCode.HarvestFault, run.ExitCode);
        Assert.Equal(["", "--resume"], File.ReadAllLines(_folder.PathOf(StandIn.Starts))[..2]);
        Assert.Contains("Given up after 1 restarts without a new frame.", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Program_that_goes_on_after_its_end_is_not_restarted()
    {
        CliRun run = Supervise("lingers", "--timeout", "1");

        run.AssertDone();
        Assert.Contains("has finished (it went on and was ended), frames: 1", run.Out, StringComparison.Ordinal);
        Assert.Equal([""], File.ReadAllLines(_folder.PathOf(StandIn.Starts)));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Plan_with_skipped_trials_is_not_repeated()
    {
        CliRun run = Supervise("skips");

        run.AssertFailed(ExitCode.HarvestFault, "trials were skipped");
        Assert.Equal([""], File.ReadAllLines(_folder.PathOf(StandIn.Starts)));
    }

    [Theory]
    [InlineData("--launcher")]
    [InlineData("--launcher", "--any-process")]
    [Trait("Category", "Heavy")]
    public void Launcher_may_end_before_the_first_heartbeat(params string[] options)
    {
        CliRun run = Supervise("launches", options);

        run.AssertDone();
        Assert.Contains(", frames: 1", run.Out, StringComparison.Ordinal);
        Assert.Equal([""], File.ReadAllLines(_folder.PathOf(StandIn.Starts)));
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Launcher_whose_program_never_comes_is_restarted()
    {
        CliRun run = Supervise("quits", "--launcher", "--start-timeout", "1", "--max-restarts", "0");

        Assert.Equal(ExitCode.HarvestFault, run.ExitCode);
        Assert.Contains("no heartbeat within 1 s", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    [Trait("Category", "Heavy")]
    public void Another_restart_argument_or_none_can_be_given()
    {
        Supervise("crashes-always", "--max-restarts", "1", "--restart-argument", "--again");
        Supervise("crashes-always", "--max-restarts", "1", "--restart-argument", "none");

        Assert.Equal(["", "--again", "", ""], File.ReadAllLines(_folder.PathOf(StandIn.Starts)));
    }

    [Fact]
    public void Process_of_another_system_is_not_watched()
    {
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        const string launcher = """
            sleep 5 > /dev/null 2>&1 &
            printf '{"process": %d, "time": "%s", "state": "running", "trial": null, "frames": 1}' \
              $! "$(date -u +%Y-%m-%dT%H:%M:%SZ)" > "$0"
            """;
        CliRun run = CliRun.Of(
            "supervise",
            "--heartbeat",
            _folder.Path,
            "--max-restarts",
            "0",
            "--any-process",
            "--",
            "sh",
            "-c",
            launcher,
            _folder.PathOf("heartbeat.json")
        );

        Assert.Equal(ExitCode.HarvestFault, run.ExitCode);
        Assert.Contains("crashed: it ended (exit code 0)", run.Out, StringComparison.Ordinal);
    }

    [Fact]
    public void Program_that_does_not_exist_is_reported() =>
        CliRun
            .Of("supervise", "--heartbeat", _folder.Path, "--", _folder.PathOf("none"))
            .AssertFailed(ExitCode.InputOutput, "cannot be started");

    [Fact]
    public void Command_to_supervise_is_required() =>
        CliRun.Of("supervise", "--heartbeat", _folder.Path).AssertFailed(ExitCode.Usage, "COMMAND is missing.");

    [Theory]
    [InlineData("TERM", 143)]
    [InlineData("INT", 130)]
    [Trait("Category", "Heavy")]
    public void Signal_is_passed_on(string signal, int code)
    {
        if (OperatingSystem.IsWindows())
        {
            return;
        }

        using Process supervisor = StartBeside(Words("ends-on-signal"));
        Wait(() => File.Exists(_folder.PathOf("heartbeat.json")), "the heartbeat");
        Signal(signal, supervisor.Id);

        Assert.True(supervisor.WaitForExit(Patience), HeededSignals.NotEnded);
        Assert.Equal(code, supervisor.ExitCode);
        Assert.Equal("SIG" + signal, File.ReadAllText(_folder.PathOf(StandIn.Stopped)));
    }

    /// <summary>Starts the command in a process of its own.</summary>
    private static Process StartBeside(params string[] arguments)
    {
        string program = Path.Combine(AppContext.BaseDirectory, "harvester.dll");
        string words = string.Join(' ', arguments.Prepend(program).Select(ShellWord.Of));
        return Process.Start(
            new ProcessStartInfo("sh", ["-c", $"{HeededSignals.Script}exec $heeding dotnet {words}"])
            {
                RedirectStandardInput = true,
                RedirectStandardOutput = true,
            }
        )!;
    }

    private static void Signal(string signal, int process)
    {
        using Process kill = Process.Start("kill", [$"-{signal}", $"{process}"]);
        kill.WaitForExit();
    }

    /// <summary>Whether a process has ended, even if nobody has asked for its exit code yet.</summary>
    private static bool IsEnded(string process)
    {
        try
        {
            return File.ReadAllText($"/proc/{process}/stat").Contains(") Z", StringComparison.Ordinal);
        }
        catch (IOException)
        {
            return true;
        }
    }

    private static void Wait(Func<bool> condition, string what)
    {
        var time = Stopwatch.StartNew();
        while (!condition())
        {
            Assert.True(time.Elapsed < Patience, $"Waited in vain for {what}.");
            Thread.Sleep(10);
        }
    }

    /// <summary>
    /// Runs a stand-in that misbehaves once. On a busy machine the start that finishes may be ended for its slowness: then one follows.
    /// </summary>
    private void AssertRestarted(string behaviour, string reason, params string[] options)
    {
        CliRun run = Supervise(behaviour, options);

        run.AssertDone();
        string[] lines = run.Out.Split('\n', StringSplitOptions.RemoveEmptyEntries);
        Assert.Contains(reason, lines[1], StringComparison.Ordinal);
        Assert.Contains("has finished (exit code 0), frames: 2", lines[^1], StringComparison.Ordinal);
        Assert.All(lines, line => Assert.Matches(@"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ ", line));
        Assert.Equal(["", "--resume"], File.ReadAllLines(_folder.PathOf(StandIn.Starts))[..2]);
    }

    private CliRun Supervise(string behaviour, params string[] options) => CliRun.Of(Words(behaviour, options));

    private string[] Words(string behaviour, params string[] options) =>
        [
            "supervise",
            "--heartbeat",
            _folder.Path,
            "--delay",
            "0.01",
            .. options,
            "--",
            "dotnet",
            typeof(Program).Assembly.Location,
            "stand-in",
            _folder.Path,
            behaviour,
        ];
}
