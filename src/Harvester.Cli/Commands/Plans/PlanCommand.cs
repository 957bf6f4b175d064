using System.CommandLine;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Commands.Plans;

/// <summary>harvester plan: works with plans, the trials of an experiment in one file.</summary>
internal static class PlanCommand
{
    private const string Notes =
        "A plan names places, weathers, hours, cameras and repetitions; every combination is a trial and becomes a session.\n"
        + "docs/plans.md describes the file.\n\n"
        + "Examples:\n"
        + "  harvester plan init plan.json\n"
        + "  harvester plan check plan.json\n"
        + "  harvester plan show plan.json\n"
        + "  harvester plan run plan.json --out experiment";

    public static Command Create(Terminal terminal)
    {
        var command = new Command("plan", "Write, check, show and run plans of many trials.");
        command.Subcommands.Add(PlanInitCommand.Create(terminal));
        command.Subcommands.Add(PlanCheckCommand.Create(terminal));
        command.Subcommands.Add(PlanShowCommand.Create(terminal));
        command.Subcommands.Add(PlanResolveCommand.Create(terminal));
        command.Subcommands.Add(PlanRunCommand.Create(terminal));
        HelpWithNotes.AddTo(command, Notes);
        return command;
    }

    /// <summary>The argument of the commands that read a plan.</summary>
    public static Argument<FileInfo> PlanArgument() => new("PLAN") { Description = "The plan, a JSON file" };
}
