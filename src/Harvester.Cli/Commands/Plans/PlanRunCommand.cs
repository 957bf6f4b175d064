using System.CommandLine;
using Harvester.Cli.Arguments;
using Harvester.Cli.Terminals;
using Harvester.Runs.Faults;
using Harvester.Runs.Plans;
using Harvester.Sessions.Files;
using Harvester.Sessions.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Plans;

/// <summary>harvester plan run: harvests every trial of a plan from the simulated game.</summary>
internal sealed class PlanRunCommand
{
    private const string Notes =
        "Every trial becomes a session in DIR/trials/ID. DIR also has a copy of the plan; world.json, which tells other roads, other\n"
        + "paint and another detail apart; plan-status.jsonl, a line for each attempt that has ended; and heartbeat.json, renewed at most\n"
        + "once a second.\n"
        + "A trial that fails is repeated; after three failures it is skipped, and the exit code is 4. Whatever stopped the command,\n"
        + "--resume continues it, and the result has the bytes of a run that was not stopped. With --shard I/N, every N-th trial is run;\n"
        + "the shards may share DIR.\n\n"
        + "Examples:\n"
        + "  harvester plan run plan.json --out experiment\n"
        + "  harvester plan run plan.json --out experiment --resume\n"
        + "  harvester plan run plan.json --roads roads.csv.gz --paint paint.csv --out experiment\n"
        + "  harvester plan run plan.json --out experiment --shard 2/8";

    private Option<string> Out { get; } =
        new("--out")
        {
            Description = "Folder to write to",
            HelpName = "DIR",
            Required = true,
        };
    private Option<bool> Resume { get; } = new("--resume") { Description = "Continue a run of the plan in the folder, or start one" };
    private Option<Shard> ShardOf { get; } = ShardOption.Create("Run only every N-th trial, as run I of N parallel runs");
    private Option<SyncMode> Sync { get; } = SyncOption.Create();
    private Option<long?> MinFree { get; } = MinFreeOption.Create();
    private PlanWorldOptions World { get; } = new();
    private Option<FileInfo?> Paint { get; } = LaneOptions.Paint();

    public static Command Create(Terminal terminal) => new PlanRunCommand().Build(terminal);

    private Command Build(Terminal terminal)
    {
        Argument<FileInfo> plan = PlanCommand.PlanArgument();
        var command = new Command("run", "Harvest every trial of a plan from the simulated game.")
        {
            plan,
            Out,
            Resume,
            ShardOf,
            Sync,
            MinFree,
        };
        World.AddTo(command);
        command.Options.Add(Paint);
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction(
            (parsed, cancellation) =>
                Task.FromResult(Run(terminal, PlanFile.Read(parsed.GetRequiredValue(plan).FullName), parsed, cancellation))
        );
        return command;
    }

    private int Run(Terminal terminal, PlanFile file, ParseResult parsed, CancellationToken cancellation)
    {
        string folder = parsed.GetRequiredValue(Out);
        var disk = new PlanDisk(parsed.GetValue(Sync), MinFreeOption.BytesIn(parsed, MinFree));
        Shard shard = parsed.GetValue(ShardOf);
        PlanWorld world = World.Parse(parsed) with { Paint = parsed.GetValue(Paint)?.FullName };
        Trial[] trials = [.. TrialList.Of(file.Plan, world.PlacesOf(file.Plan)).Where((_, index) => shard.Takes(index))];
        using var output = PlanOutput.Open(folder, file.Text, world.ToJson(file.Plan), shard, parsed.GetValue(Resume), disk.MinFreeBytes);
        long images = output.Left(trials).Sum(trial => (long)PlanRun.ImagesOf(file, trial));
        if (images > int.MaxValue)
        {
            throw new UsageException(
                FormattableString.Invariant(
                    $"The plan has {images} images; a run may have {int.MaxValue}. Divide it with --shard, or take fewer frames."
                )
            );
        }

        terminal.Out.WriteLine(
            $"Running {Counted.Of(trials.Length, "trial")} of the plan {file.Plan.Name}, {PlanEstimate.Of(file, trials)}, to {folder}"
        );
        terminal.Out.Flush();
        var heartbeat = new HeartbeatFile(folder, file.Plan.Name, shard);
        var run = new PlanRun(terminal, file, world, output, heartbeat, CommandText.Of(parsed))
        {
            Disk = disk,
            NotesTrials = !terminal.IsInteractive,
        };
        var end = HeartbeatState.Failed;
        try
        {
            int code = new JobProgress(terminal, (int)images, "images").Run(report =>
                run.Run(trials, report, cancellation) ? ExitCode.Done : ExitCode.InputOutput
            );
            code = code == ExitCode.Done ? Summarise(terminal, trials, output, folder) : code;
            end =
                code == ExitCode.Done ? HeartbeatState.Finished
                : code == ExitCode.HarvestFault ? HeartbeatState.Incomplete
                : HeartbeatState.Failed;
            return code;
        }
        catch (OperationCanceledException)
        {
            terminal.WriteError("Stopped; all sessions are valid. To continue, give the same command with --resume.");
            return ExitCode.Cancelled;
        }
        finally
        {
            heartbeat.End(end, run.Frames);
            heartbeat.Wait();
        }
    }

    private static int Summarise(Terminal terminal, IReadOnlyList<Trial> trials, PlanOutput output, string folder)
    {
        TrialResult[] results = [.. trials.Select(trial => output.Status.Last[trial.Id])];
        TrialResult[] skipped = [.. results.Where(result => result.State == TrialState.Skipped)];
        terminal.Out.WriteLine(
            $"{Counted.Of(results.Length - skipped.Length, "trial")} done, {skipped.Length} skipped, "
                + Counted.Of(results.Where(result => result.State == TrialState.Done).Sum(result => (long)result.Frames), "frame")
        );
        terminal.Out.WriteLine($"sessions {output.Trials}");
        if (skipped.Length == 0)
        {
            return ExitCode.Done;
        }

        terminal.WriteError(
            FormattableString.Invariant($"{Counted.Of(skipped.Length, "trial")} skipped after {TrialResult.MaxAttempts} failures each: ")
                + string.Join(", ", skipped.Select(result => result.Trial))
        );
        return ExitCode.HarvestFault;
    }
}
