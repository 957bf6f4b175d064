using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Runs.Supervising;

namespace Harvester.Cli.Commands;

/// <summary>harvester supervise: keeps a game or a long command going, by its heartbeat.</summary>
internal sealed class SuperviseCommand
{
    private const double MaxSeconds = 1_000_000;
    private const string None = "none";

    private const string Notes =
        "The command after -- is started and its heartbeat file is watched. It is ended with all processes that it started, and started\n"
        + "again with --resume, when it hangs (no new heartbeat), crashes (it ends and the heartbeat does not say finished) or lies (a\n"
        + "heartbeat without new frames, from the future, or of a foreign process). Once the heartbeat says finished, it is not started\n"
        + "again; one that goes on is ended. Ctrl+C and SIGTERM are passed on. docs/supervise.md describes the file and the exit codes.\n\n"
        + "Examples:\n"
        + "  harvester supervise --heartbeat night -- harvester plan run plan.json --out night\n"
        + "  harvester supervise --heartbeat out --timeout 120 --restart-argument none --launcher -- PlayGTAV.exe";

    private Argument<string[]> Program { get; } =
        new("COMMAND") { Description = "The command and its arguments, after --", Arity = ArgumentArity.OneOrMore };

    private Option<string> HeartbeatPath { get; } =
        new("--heartbeat")
        {
            Description = "The heartbeat file, or the output folder that has heartbeat.json",
            HelpName = "PATH",
            Required = true,
        };

    private Option<double> Timeout { get; } = Seconds("--timeout", "Time without a new heartbeat after which it hangs, seconds", 60);
    private Option<double> StartTimeout { get; } = Seconds("--start-timeout", "Time it may take until it is running, seconds", 600);
    private Option<double> Stall { get; } = Seconds("--stall", "Time that a running one may take for a frame, seconds", 300);
    private Option<double> Delay { get; } =
        Seconds("--delay", "Wait before a restart, seconds; it doubles with each restart without progress, up to 5 minutes", 5);

    private Option<int> MaxRestarts { get; } =
        ValueParsers.Integer("--max-restarts", "N", "Restarts in a row without progress before it gives up", 0, 1_000_000);

    private Option<string> RestartArgument { get; } =
        new("--restart-argument")
        {
            Description = "Argument to add when it is started again; none adds nothing",
            HelpName = "ARG",
            DefaultValueFactory = _ => ResumeOption.Name,
        };

    private Option<bool> AnyProcess { get; } =
        new("--any-process")
        {
            Description = "Do not check the process of a heartbeat: under Wine and in containers it has another number",
        };

    private Option<bool> Launcher { get; } =
        new("--launcher")
        {
            Description = "The command only starts the program and may end before its first heartbeat, as game launchers do",
        };

    public static Command Create(Terminal terminal) => new SuperviseCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        MaxRestarts.DefaultValueFactory = _ => 5;
        var command = new Command(
            "supervise",
            "Keep a game or a long command going: restart it when it hangs, crashes or reports a false state."
        )
        {
            Program,
            HeartbeatPath,
            Timeout,
            StartTimeout,
            Stall,
            Delay,
            MaxRestarts,
            RestartArgument,
            AnyProcess,
            Launcher,
        };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, cancellation) => Task.FromResult(Run(terminal, parsed, cancellation)));
        return command;
    }

    private int Run(Terminal terminal, ParseResult parsed, CancellationToken cancellation)
    {
        string[] words = parsed.GetRequiredValue(Program);
        string path = parsed.GetRequiredValue(HeartbeatPath);
        string restart = parsed.GetRequiredValue(RestartArgument);
        var options = new SupervisorOptions
        {
            Program = words[0],
            Arguments = words[1..],
            HeartbeatPath = Path.GetExtension(path) == ".json" ? path : Path.Combine(path, HeartbeatReader.FileName),
            Timeout = TimeSpan.FromSeconds(parsed.GetValue(Timeout)),
            StartTimeout = TimeSpan.FromSeconds(parsed.GetValue(StartTimeout)),
            Stall = TimeSpan.FromSeconds(parsed.GetValue(Stall)),
            Delay = TimeSpan.FromSeconds(parsed.GetValue(Delay)),
            MaxRestarts = parsed.GetValue(MaxRestarts),
            RestartArgument = restart == None ? null : restart,
            AllowsAnyProcess = parsed.GetValue(AnyProcess),
            IsLauncher = parsed.GetValue(Launcher),
        };
        using var signal = new PassedSignal();
        return new Supervisor(options, terminal, signal).Run(cancellation) switch
        {
            SupervisorEnd.Finished => ExitCode.Done,
            SupervisorEnd.Cancelled => ExitCode.Cancelled,
            _ => ExitCode.HarvestFault,
        };
    }

    private static Option<double> Seconds(string name, string description, double standard)
    {
        Option<double> option = ValueParsers.Number(
            name,
            "S",
            description,
            value => value is > 0 and <= MaxSeconds,
            "a number greater than 0 and at most 1000000"
        );
        option.DefaultValueFactory = _ => standard;
        return option;
    }
}
