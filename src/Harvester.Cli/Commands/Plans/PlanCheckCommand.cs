using System.CommandLine;
using Harvester.Cli.Terminals;
using Harvester.Runs.Plans;
using Harvester.Sessions.Text;

namespace Harvester.Cli.Commands.Plans;

/// <summary>harvester plan check: lists every problem of a plan.</summary>
internal static class PlanCheckCommand
{
    private const string Notes =
        "Prints a line for each problem, which names the field. The exit code is 1 if there is one.\n\n"
        + "Example:\n"
        + "  harvester plan check plan.json";

    public static Command Create(Terminal terminal)
    {
        Argument<FileInfo> plan = PlanCommand.PlanArgument();
        var command = new ResultCommand("check", "List every problem of a plan.") { plan };
        HelpWithNotes.AddTo(command, Notes);
        command.SetAction((parsed, _) => Task.FromResult(Run(terminal, parsed.GetRequiredValue(plan))));
        return command;
    }

    private static int Run(Terminal terminal, FileInfo plan)
    {
        List<string> problems = PlanFile.ProblemsOf(plan.FullName, out PlanFile? file);
        foreach (string problem in problems)
        {
            terminal.WriteQuoting(problem);
        }

        terminal.WriteQuoting(file is null ? $"{plan}: {Counted.Of(problems.Count, "problem")}" : $"{plan}: the plan is valid");
        return file is null ? ExitCode.BadData : ExitCode.Done;
    }
}
