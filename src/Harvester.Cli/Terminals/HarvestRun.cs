using Harvester.Datasets.Outputs;
using Harvester.Datasets.Statistics;
using Harvester.Reports.Sessions;
using Harvester.Runs.Harvesting;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Terminals;

/// <summary>Harvests a plan in a terminal, with progress and result.</summary>
internal static class HarvestRun
{
    /// <summary>Harvests a plan, and reports progress and result.</summary>
    /// <param name="terminal">Receives the messages.</param>
    /// <param name="plan">The plan.</param>
    /// <param name="command">The command as text, by which an unfinished session is known again.</param>
    /// <param name="withReport">Whether a report is written.</param>
    /// <param name="cancellation">Stops after the current frame.</param>
    public static int Of(Terminal terminal, HarvestPlan plan, string command, bool withReport, CancellationToken cancellation)
    {
        if (plan.Resume && FinishedResult.Of(plan.Folder, () => FinishedHarvest.FramesIn(plan)) is { } frames)
        {
            terminal.Out.WriteLine($"{plan.Folder}: {Counted.Of(frames, "frame")}; the harvest is finished already.");
            return ExitCode.Done;
        }

        using var output = new SessionOutput(
            terminal.WriteError,
            plan.Folder,
            command,
            plan.Overwrite,
            keepsFrames: true,
            plan.Resume,
            minFreeBytes: plan.Options.MinFreeBytes
        );
        terminal.Out.WriteLine($"Harvesting {plan.Description}, seed {plan.Seed}, to {plan.Folder}");
        terminal.Out.Flush();
        SimulatedHarvest harvest = SimulatedHarvest.Build(plan, terminal.WriteError);
        string written = output.Begin();
        HarvestOutcome outcome = new JobProgress(terminal, plan.Frames).Run(report => harvest.Run(written, report, cancellation));
        foreach (string warning in outcome.Warnings)
        {
            terminal.WriteError(warning);
        }

        if (outcome.Fault is { } fault)
        {
            terminal.WriteError(
                output.KeepsFormer
                    ? $"{fault.Replace(written, plan.Folder, StringComparison.Ordinal)} The former session is unchanged; the new "
                        + "frames are deleted."
                    : fault
            );
            return ExitCode.Of(outcome);
        }

        if (outcome.IsCancelled && output.KeepsFormer)
        {
            terminal.WriteError(
                $"Stopped after {outcome.Frames} of {Counted.Of(plan.Frames, "frame")}, which are deleted; the session in "
                    + $"'{plan.Folder}' is unchanged."
            );
            return ExitCode.Of(outcome);
        }

        if (outcome.IsCancelled && outcome.Frames == 0)
        {
            terminal.WriteError("Stopped before the first frame.");
            return ExitCode.Of(outcome);
        }

        var session = new SessionReader(written);
        bool hasPage = withReport && !outcome.IsCancelled && plan.Options.Shard.Count == 1;
        if (hasPage)
        {
            new ReportWriter(session).Write(Path.Combine(written, ReportWriter.FileName));
        }

        SessionStatistics statistics = SessionStatistics.Of(session.ReadLabels());
        if (!outcome.IsCancelled)
        {
            output.Complete();
        }

        HarvestSummary.Write(terminal, plan, outcome, statistics, hasPage ? Path.Combine(plan.Folder, ReportWriter.FileName) : null);
        if (outcome.IsCancelled)
        {
            terminal.WriteError(
                $"Stopped after {outcome.Frames} of {Counted.Of(plan.Frames, "frame")}; the session is valid. To continue, give the same "
                    + "command with --resume; without it, the command starts over."
            );
        }

        return ExitCode.Of(outcome);
    }
}
